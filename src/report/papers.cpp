#include "report/papers.hpp"

#include <algorithm>

#include "base/choose.hpp"
#include "base/errors.hpp"

namespace report {

std::vector<Paper> papers(const Table& table) {
    std::vector<Paper> all;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto word = [&](const char* name) { return table.word(row, name); };
        all.push_back(
            {word("letter"),
             word("paper"),
             word("citation"),
             word("own") == "yes",
             {word("conventions"), {word("one"), word("if_one")}, {word("other"), word("if_other")}}});
    }
    return all;
}

const Paper& paper_named(const std::string& folder, const std::vector<Paper>& papers) {
    std::vector<std::pair<std::string, const Paper*>> known;
    known.reserve(papers.size());
    for (const Paper& paper : papers) known.emplace_back(paper.folder, &paper);
    return *base::choose("paper", folder, known);
}

std::map<std::string, Table> by_paper(const Table& table, const std::vector<Paper>& papers) {
    std::map<std::string, Table> parts;
    for (const Paper& paper : papers) parts[paper.folder] = {table.comments, table.columns, {}};
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const std::string key = table.word(row, table.columns.front().name);
        const auto of = std::find_if(papers.begin(), papers.end(),
                                     [&](const Paper& paper) { return key.starts_with(paper.letter); });
        if (of == papers.end()) throw base::FailedComputation(key + " belongs to no paper");
        parts[of->folder].rows.push_back(table.rows[row]);
    }
    return parts;
}

}  // namespace report
