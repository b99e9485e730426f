#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "command_line/command_line.hpp"
#include "report/file.hpp"
#include "report/papers.hpp"
#include "report/table.hpp"

namespace {

using base::FailedComputation;
using report::Paper;
using report::read_whole;
using report::Table;

Table table_of(const std::string& path) {
    return report::parsed_words(read_whole(path));
}

/// A paper with its equations, its claims and the verdicts on these.
struct Reproduction {
    Paper paper;
    Table equations, claims, verdicts;
};

/// Every paper of which there is something.
/// \throws FailedComputation for one with equations or claims but no verdicts
std::vector<Reproduction> reproductions(const Table& equations, const Table& claims) {
    const auto papers = report::papers(table_of("paper/papers.csv"));
    const auto equation_parts = report::by_paper(equations, papers);
    const auto claim_parts = report::by_paper(claims, papers);
    std::vector<Reproduction> all;
    for (const Paper& paper : papers) {
        const Table& its_equations = equation_parts.at(paper.folder);
        const Table& its_claims = claim_parts.at(paper.folder);
        const std::string verdicts = "data/" + paper.folder + "/claims.csv";
        if (std::filesystem::exists(verdicts))
            all.push_back({paper, its_equations, its_claims, table_of(verdicts)});
        else if (!its_equations.rows.empty() || !its_claims.rows.empty())
            throw FailedComputation(verdicts + " is missing; run make claims");
    }
    return all;
}

/// The reproduction in a folder; null for a folder of no paper.
const Reproduction* reproduction_of(const std::string& folder, const std::vector<Reproduction>& all) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Reproduction& of) { return of.paper.folder == folder; });
    return found == all.end() ? nullptr : &*found;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
    return text;
}

/// Text for a cell of a Markdown table in Doxygen: nothing in it is taken for markup.
std::string cell(std::string text) {
    for (const char* mark : {"\\", "|", "#", "@", "*", "_", "<", ">"})
        text = replaced(text, mark, std::string("\\") + mark);
    return text;
}

/// The number in an equation's key: A16 -> 16.
std::string number(const std::string& equation) {
    return equation.substr(1);
}

/// The anchor of an equation ("index"), of a claim ("claim") or of a section's claims ("claims"). Doxygen's anchors have no dots.
std::string anchor_of(const std::string& kind, const std::string& key) {
    return kind + "_" + replaced(key, ".", "_");
}

/// The text of a cell with its paper's equations that it names, "(16)", as links.
std::string linked(const std::string& text, const Table& equations) {
    std::string with_links = cell(text);
    for (std::size_t row = 0; row < equations.rows.size(); ++row) {
        const std::string equation = equations.word(row, "equation");
        with_links = replaced(with_links, "(" + number(equation) + ")", "\\eq{" + equation + "}");
    }
    return with_links;
}

/// Where the tests of a file stand on their page: asprone2010/claims_test.cpp -> test_asprone2010_claims_test.
std::string anchor(const std::string& test) {
    return "test_" + replaced(test.substr(0, test.rfind('.')), "/", "_");
}

/// A section's namespace page by the file that holds it: asprone2010/section_3_1_original.hpp -> asprone2010::original.
std::string section_page(const std::string& code) {
    static const std::regex shape(R"re((\w+)/section_[0-9_]+(\w+)\.hpp)re");
    std::smatch found;
    if (!std::regex_match(code, found, shape)) throw FailedComputation(code + " is no section's file");
    return found[1].str() + "::" + found[2].str();
}

/// The names of the test cases in a test file.
std::vector<std::string> test_cases(const std::string& path) {
    static const std::regex shape(R"re(TEST_CASE\(((?:\s*"(?:[^"\\]|\\.)*")+)\s*\))re");
    static const std::regex part(R"re("((?:[^"\\]|\\.)*)")re");
    const std::string source = read_whole(path);
    std::vector<std::string> names;
    for (std::sregex_iterator test(source.begin(), source.end(), shape), end; test != end; ++test) {
        const std::string literal = (*test)[1];
        std::string name;
        for (std::sregex_iterator piece(literal.begin(), literal.end(), part); piece != end; ++piece)
            name += (*piece)[1];
        names.push_back(replaced(name, "\\\"", "\""));
    }
    return names;
}

/// The equations that stand above code, each with the file that holds it.
std::map<std::string, std::vector<std::string>> defined_equations(const std::string& source) {
    static const std::regex tag(R"re(\\defeq\{(\w[\w.]*)\})re");
    std::map<std::string, std::vector<std::string>> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source)) {
        if (entry.path().extension() != ".hpp") continue;
        const std::string text = read_whole(entry.path());
        for (std::sregex_iterator match(text.begin(), text.end(), tag), end; match != end; ++match)
            found[(*match)[1]].push_back(std::filesystem::relative(entry.path(), source).generic_string());
    }
    return found;
}

/// Compares the list of equations with the source and the tests, both ways.
/// \throws FailedComputation naming the first equation without code or test, or code without a row
void check_equations(const Table& equations) {
    auto defined = defined_equations("src");
    for (std::size_t row = 0; row < equations.rows.size(); ++row) {
        const std::string equation = equations.word(row, "equation");
        const std::string code = equations.word(row, "code"), test = "tests/" + equations.word(row, "test");
        if (defined[equation] != std::vector<std::string>{code})
            throw FailedComputation("equation " + equation + " must stand once above its code in src/" +
                                    code + ", with \\defeq{" + equation + "}");
        bool tested = false;
        for (const std::string& name : test_cases(test))
            tested = tested || name.find("(" + number(equation) + ")") != std::string::npos;
        if (!tested) throw FailedComputation("equation " + equation + " is named by no test case of " + test);
        defined.erase(equation);
    }
    for (const auto& [equation, files] : defined)
        if (!files.empty())
            throw FailedComputation("equation " + equation + " of src/" + files.front() + " has no row");
}

/// The index: every equation with its code, its test and the claims about it, paper by paper.
std::string equation_page(const std::vector<Reproduction>& all) {
    std::string page =
        "Equations {#equations}\n=========\n\nEvery numbered equation, with the code that stands below it, "
        "the tests that name it, and the verdicts on what the paper claims about it.\n";
    for (const auto& [paper, equations, claims, verdicts] : all) {
        page += "\n## " + paper.citation +
                "\n\n| equation | section | says | tests | claims |\n| --- | --- | --- | --- | --- |\n";
        for (std::size_t row = 0; row < equations.rows.size(); ++row) {
            const std::string equation = equations.word(row, "equation");
            std::string about;
            for (std::size_t claim = 0; claim < claims.rows.size(); ++claim)
                if ((" " + claims.word(claim, "equations") + " ").find(" " + number(equation) + " ") !=
                    std::string::npos)
                    about += " \\claim{" + claims.word(claim, "id") + "}";
            page += "| \\anchor " + anchor_of("index", equation) + " \\eq{" + equation + "} | \\ref " +
                    section_page(equations.word(row, "code")) + " \"" + equations.word(row, "section") +
                    "\" | " + cell(equations.word(row, "meaning")) + " | \\ref " +
                    anchor(equations.word(row, "test")) + " \"tests\" | " + about + " |\n";
        }
    }
    return page;
}

/// How many claims of a section have which verdict: "5 of 7 reproduced, 1 conditional, 1 differs".
std::string tally(const Table& verdicts, const std::string& section) {
    int all = 0, reproduced = 0, differ = 0, undecided = 0;
    for (std::size_t row = 0; row < verdicts.rows.size(); ++row) {
        if (verdicts.word(row, "section") != section) continue;
        const std::string verdict = verdicts.word(row, "verdict");
        ++all;
        if (verdict == "reproduced") ++reproduced;
        if (verdict == "differs") ++differ;
        if (verdict == "cannot tell") ++undecided;
    }
    const int conditional = all - reproduced - differ - undecided;
    if (all == 0) return "";
    std::string text = std::to_string(reproduced) + " of " + std::to_string(all) + " reproduced";
    if (conditional > 0) text += ", " + std::to_string(conditional) + " under a condition";
    if (differ > 0) text += ", " + std::to_string(differ) + (differ == 1 ? " differs" : " differ");
    if (undecided > 0) text += ", " + std::to_string(undecided) + " undecided";
    return text;
}

/// A claim in words, with links to the equations that it names and, behind it, to those it is about without naming them.
std::string claim_of(const Reproduction& of, std::size_t row) {
    std::string text = linked(of.claims.word(row, "claim"), of.equations);
    std::istringstream numbers(of.claims.word(row, "equations"));
    for (std::string each; numbers >> each;)
        if (const std::string link = "\\eq{" + of.paper.letter + each + "}";
            text.find(link) == std::string::npos)
            text += " " + link;
    return text;
}

/// A paper's ledger, section by section: every claim with what was measured; what is not reproduced stands out.
std::string claims_of(const Reproduction& of) {
    const auto& [paper, equations, claims, verdicts] = of;
    const auto& [about, one, other] = paper.conventions;
    std::map<std::string, std::string> sections;
    for (std::size_t row = 0; row < claims.rows.size(); ++row) {
        const std::string id = claims.word(row, "id");
        if (row >= verdicts.rows.size() || verdicts.word(row, "id") != id)
            throw FailedComputation("claim " + id + " has no verdict yet; run make claims");
        const std::string conditional = verdicts.word(row, "conditional"),
                          verdict = verdicts.word(row, "verdict");
        const std::string shown = verdict == "reproduced" ? verdict : "**" + cell(verdict) + "**";
        sections[claims.word(row, "section")] +=
            "| \\anchor " + anchor_of("claim", id) + " \\ref " + anchor(claims.word(row, "test")) + " \"" +
            id + "\" | " + claim_of(of, row) + " | " + shown +
            (conditional.empty() ? "" : " (then " + conditional + ")") + " | " +
            linked(claims.word(row, "quantity"), equations) + ": " + cell(verdicts.word(row, "statement")) +
            " (" + cell(claims.word(row, "reason")) + ") | " + verdicts.word(row, "measured_" + one.name) +
            " | " + verdicts.word(row, "measured_" + other.name) + " |\n";
    }
    std::string text = "## " + paper.citation + "\n\nThe two conventions: " + one.name + ", " +
                       one.condition + "; " + other.name + ", " + other.condition + ".\n\n";
    for (const auto& [section, rows] : sections)
        text += "### Section " + section + ": " + tally(verdicts, section) + "\n\n\\anchor " +
                anchor_of("claims", paper.letter + "-" + section) +
                "\n\n| claim | says | verdict | stated of (why so closely) | " + one.name + " | " +
                other.name + " |\n| --- | --- | --- | --- | --- | --- |\n" + rows + "\n";
    return text;
}

std::string claims_page(const std::vector<Reproduction>& all) {
    std::string page =
        "Claims {#claims}\n======\n\nEvery statement of a paper that a measurement can confirm or refute, in "
        "our words. Each verdict is computed: the statement is compared with what was measured under two "
        "conventions between which the print does not decide. The name of a claim leads to the tests of its "
        "subject.\n\n";
    for (const Reproduction& of : all) page += claims_of(of);
    return page;
}

/// What a paper's print leaves open: the same quantities with one choice and with another, a table for each pair of choices.
std::string choices_of(const Paper& paper, const Table& choices) {
    std::string text = "\n## " + paper.citation + "\n\nThe \\ref companion_" + paper.folder +
                       " \"companion\" says what we chose and why.\n";
    std::string current;
    for (std::size_t row = 0; row < choices.rows.size(); ++row) {
        const auto word = [&](const char* name) { return cell(choices.word(row, name)); };
        if (const std::string head = word("choice"); head != current) {
            text += "\n### " + head + "\n\n| quantity | formulation | " + word("one") + " | " +
                    word("other") + " |\n| --- | --- | --- | --- |\n";
            current = head;
        }
        text += "| " + word("quantity") + " | " + word("formulation") + " | " + word("with_one") + " | " +
                word("with_other") + " |\n";
    }
    return text;
}

std::string choices_page(const std::vector<Reproduction>& all) {
    std::string page = "Choices {#choices}\n=======\n\nWhat the print leaves open, measured both ways.\n";
    for (const Reproduction& of : all)
        if (const std::string choices = "data/" + of.paper.folder + "/choices.csv";
            std::filesystem::exists(choices))
            page += choices_of(of.paper, table_of(choices));
    return page;
}

/// The tests: the properties that they state, file by file, and their source.
std::string tests_page(const std::vector<std::string>& files, const std::vector<Reproduction>& all) {
    std::string page =
        "Tests {#tests}\n=====\n\nWhat the tests of each file state. `make check` runs them all.\n\n";
    for (const std::string& file : files) {
        const std::string name_of_file = file.substr(std::string("tests/").size());
        page += "\\section " + anchor(name_of_file) + " " + name_of_file + "\n";
        const Reproduction* of = reproduction_of(name_of_file.substr(0, name_of_file.find('/')), all);
        for (const std::string& name : test_cases(file))
            page += "- " + (of ? linked(name, of->equations) : cell(name)) + "\n";
        page += "\n";
    }
    return page;
}

/// The table of doc/reproduction.md: paper item, command, output, source, verdict.
std::string readme_table(const Table& items, const std::vector<Reproduction>& all) {
    std::string text = "| paper | command | output | source | claims |\n| --- | --- | --- | --- | --- |\n";
    const auto link = [](const std::string& path) {
        return "[" + std::filesystem::path(path).filename().string() + "](../" + path + ")";
    };
    for (std::size_t row = 0; row < items.rows.size(); ++row) {
        const Reproduction* of = reproduction_of(items.word(row, "paper"), all);
        if (!of)
            throw FailedComputation("'" + items.word(row, "item") + "' of paper/items.csv is of no paper");
        std::string outputs;
        std::istringstream words(items.word(row, "output"));
        for (std::string path; words >> path;) outputs += (outputs.empty() ? "" : ", ") + link(path);
        text += "| " + items.word(row, "item") + " | `" + items.word(row, "command") + "` | " + outputs +
                " | " + link(items.word(row, "source")) + " | " +
                tally(of->verdicts, items.word(row, "section")) + " |\n";
    }
    return text;
}

/// A text with the part between two marks replaced. \throws FailedComputation where the marks are missing
std::string with_part(const std::string& text, const std::string& part) {
    const std::string first = "<!-- the table below is written by make claims -->\n",
                      last = "<!-- end of the table -->";
    const std::size_t from = text.find(first), to = text.find(last);
    if (from == std::string::npos || to == std::string::npos)
        throw FailedComputation("doc/reproduction.md has lost the marks of its table");
    return text.substr(0, from + first.size()) + part + text.substr(to);
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Writes the generated pages of the walkthrough and the table of doc/reproduction.md, and checks that "
        "every "
        "equation has code and "
        "test. It runs in the top folder.",
        "walkthrough", "Example: walkthrough --pages build/doc/pages");
    std::string pages, readme_file = "doc/reproduction.md";
    bool write_readme = false, check_readme = false;
    app.add_option("--pages", pages, "folder to write the pages into").type_name("FOLDER");
    app.add_option("--readme", readme_file, "the page to write or check (default doc/reproduction.md)")
        .type_name("FILE");
    app.add_flag("--write-readme", write_readme, "write the table of the page anew");
    app.add_flag("--check-readme", check_readme, "fail if the table of the page is stale");
    return command_line::run(app, argc, argv, [&] {
        const Table equations = table_of("paper/equations.csv"), claims = table_of("paper/claims.csv");
        check_equations(equations);
        const std::vector<Reproduction> all = reproductions(equations, claims);
        std::cout << equations.rows.size() << " equations indexed, 0 without code or test\n";
        if (!pages.empty()) {
            std::vector<std::string> files;
            for (const auto& entry : std::filesystem::recursive_directory_iterator("tests"))
                if (entry.path().string().ends_with("_test.cpp"))
                    files.push_back(entry.path().generic_string());
            std::sort(files.begin(), files.end());
            std::filesystem::create_directories(pages);
            report::write_whole(pages + "/equations.md", equation_page(all));
            report::write_whole(pages + "/claims.md", claims_page(all));
            report::write_whole(pages + "/choices.md", choices_page(all));
            report::write_whole(pages + "/tests.md", tests_page(files, all));
        }
        const std::string readme = read_whole(readme_file);
        const std::string fresh = with_part(readme, readme_table(table_of("paper/items.csv"), all));
        if (write_readme && fresh != readme) report::write_whole(readme_file, fresh);
        if (check_readme && fresh != readme)
            throw FailedComputation("the table of doc/reproduction.md is stale; run make claims");
        return 0;
    });
}
