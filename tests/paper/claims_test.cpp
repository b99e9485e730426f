#include <doctest/doctest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "asprone2010/claims/ledger.hpp"
#include "batra2008/claims/ledger.hpp"
#include "fpm_in_space/claims/ledger.hpp"
#include "report/file.hpp"
#include "report/papers.hpp"
#include "report/source.hpp"

namespace {

report::Table words_of(const std::string& path) {
    return report::parsed_words(report::read_whole(path));
}

std::vector<std::string> column(const std::string& path, const std::string& name) {
    const report::Table table = words_of(path);
    std::vector<std::string> words;
    for (std::size_t row = 0; row < table.rows.size(); ++row) words.push_back(table.word(row, name));
    return words;
}

std::set<std::string> set_of(const std::vector<std::string>& words) {
    return {words.begin(), words.end()};
}

/// The texts that refer to claims and equations: headers and companions.
std::string references() {
    std::string text;
    for (const char* folder : {"src", "paper"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".hpp" || entry.path().extension() == ".md")
                text += report::read_whole(entry.path().string());
    return text;
}

}  // namespace

TEST_CASE(
    "claims: every claim has a computation, every computation a claim, and each names a test that exists") {
    const auto papers = report::papers(words_of("paper/papers.csv"));
    const auto claims = report::by_paper(words_of("paper/claims.csv"), papers);
    for (const report::Ledger& ledger :
         {asprone2010::claims::ledger(), batra2008::claims::ledger(), fpm_in_space::claims::ledger()}) {
        const report::Table& table = claims.at(ledger.paper);
        CHECK(table.rows.size() == ledger.computations.size());
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            CAPTURE(table.word(row, "id"));
            CHECK(ledger.computations.count(table.word(row, "id")) == 1);
            CHECK_NOTHROW(report::read_whole("tests/" + table.word(row, "test")));
            CHECK_FALSE(table.word(row, "reason").empty());
        }
    }
}

TEST_CASE(
    "claims: an id says paper and section, each id is given once, and none can be taken for an equation's key") {
    const report::Table claims = words_of("paper/claims.csv");
    const auto equations = set_of(column("paper/equations.csv", "equation"));
    for (std::size_t row = 0; row < claims.rows.size(); ++row) {
        const std::string id = claims.word(row, "id"), section = claims.word(row, "section");
        CAPTURE(id);
        CHECK(id.substr(1).starts_with("-" + section + "-"));
        CHECK(std::regex_match(id, std::regex("[ABF]-[0-9.]+-[A-Za-z0-9-]+")));
        CHECK(equations.count(id) == 0);
    }
    for (const std::string& equation : equations)
        CHECK(std::regex_match(equation, std::regex("[ABF][0-9.]+")));
    const auto ids = column("paper/claims.csv", "id");
    CHECK(set_of(ids).size() == ids.size());
    auto old_ids = column("paper/claims.csv", "old_id");
    std::erase(old_ids, "");  // of a claim that never had another
    CHECK(set_of(old_ids).size() == old_ids.size());
}

TEST_CASE("claims: what headers and companions refer to as a claim or an equation is one, and never both") {
    const std::string text = references();
    const auto ids = set_of(column("paper/claims.csv", "id"));
    const auto equations = set_of(column("paper/equations.csv", "equation"));
    std::set<std::string> sections;
    for (const std::string& id : ids) sections.insert(id.substr(0, id.find('-', 2)));
    const auto check_known = [&](const char* command, const std::set<std::string>& known) {
        const auto keys = report::keys(text, command);
        CHECK_FALSE(keys.empty());
        for (const std::string& key : keys) {
            CAPTURE(key);
            CHECK(known.count(key) == 1);
        }
    };
    check_known("claim", ids);
    check_known("claims", sections);
    check_known("eq", equations);
}
