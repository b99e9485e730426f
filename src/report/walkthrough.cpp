#include "report/walkthrough.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include "base/errors.hpp"
#include "report/file.hpp"
#include "report/markdown.hpp"
#include "report/source.hpp"
#include "report/tally.hpp"

namespace report {

using base::FailedComputation;

namespace {

// The papers with what paper/ and data/ hold about them

Table table_of(const std::string& path) {
    return parsed_words(read_whole(path));
}

/// The reproduction in a folder; null for a folder of no paper.
const Reproduction* reproduction_in(const std::string& folder, const std::vector<Reproduction>& all) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Reproduction& reproduction) {
        return reproduction.paper.folder == folder;
    });
    return found == all.end() ? nullptr : &*found;
}

// Links

/// The number in an equation's key: A16 -> 16.
std::string number(const std::string& equation) {
    return equation.substr(1);
}

/// The anchor of an equation ("index"), of a claim ("claim") or of a section's claims ("claims"). Doxygen's
/// anchors have no dots.
std::string anchor(const std::string& kind, const std::string& key) {
    return kind + "_" + replaced(key, ".", "_");
}

/// The anchor of a test file on the page of tests: asprone2010/rkpm_test.cpp -> test_asprone2010_rkpm_test.
std::string anchor_of_test(const std::string& file) {
    return "test_" + replaced(file.substr(0, file.rfind('.')), "/", "_");
}

/// The text of a cell. Equations of its paper that it names, "(16)" or "(F7)", become links.
std::string linked(const std::string& text, const Table& equations) {
    std::string with_links = escaped(text);
    for (std::size_t row = 0; row < equations.rows.size(); ++row) {
        const std::string equation = equations.word(row, "equation");
        for (const std::string& name : {number(equation), equation})
            with_links = replaced(with_links, "(" + name + ")", "\\eq{" + equation + "}");
    }
    return with_links;
}

/// A section's page, its namespace, by its file: asprone2010/section_3_1_original.hpp ->
/// asprone2010::original.
std::string section_page(const std::string& code) {
    const std::string between = "/section_", after = ".hpp";
    const auto folder = code.find(between);
    const auto name = code.find_first_not_of("0123456789_", folder + between.size());
    if (folder == std::string::npos || name == std::string::npos || !code.ends_with(after))
        throw FailedComputation(code + " is no section's file");
    return code.substr(0, folder) + "::" + code.substr(name, code.size() - after.size() - name);
}

// The index of equations

/// Links to the claims about an equation.
std::string claims_about(const std::string& equation, const Table& claims) {
    std::string links;
    for (std::size_t row = 0; row < claims.rows.size(); ++row)
        if ((" " + claims.word(row, "equations") + " ").find(" " + number(equation) + " ") !=
            std::string::npos)
            links += " \\claim{" + claims.word(row, "id") + "}";
    return links;
}

std::string equations_of(const Reproduction& reproduction) {
    const auto& [paper, equations, claims, verdicts] = reproduction;
    std::string text =
        "\n## " + paper.citation + "\n\n" + head({"equation", "section", "says", "tests", "claims"});
    for (std::size_t row = 0; row < equations.rows.size(); ++row) {
        const auto word = [&, &table = equations](const char* column) { return table.word(row, column); };
        const std::string equation = word("equation");
        text += report::row({"\\anchor " + anchor("index", equation) + " \\eq{" + equation + "}",
                             "\\ref " + section_page(word("code")) + " \"" + word("section") + "\"",
                             escaped(word("meaning")), "\\ref " + anchor_of_test(word("test")) + " \"tests\"",
                             claims_about(equation, claims)});
    }
    return text;
}

// The ledger of claims

/// A claim in words. Behind it stand links to the equations that it is about without naming them.
std::string claim_in_words(const Reproduction& reproduction, std::size_t row) {
    std::string text = linked(reproduction.claims.word(row, "claim"), reproduction.equations);
    std::istringstream numbers(reproduction.claims.word(row, "equations"));
    for (std::string each; numbers >> each;)
        if (const std::string link = "\\eq{" + reproduction.paper.letter + each + "}";
            text.find(link) == std::string::npos)
            text += " " + link;
    return text;
}

/// A verdict; what is conditional or differs stands out, with the number that a condition gives.
std::string verdict_in_words(const Table& verdicts, std::size_t row) {
    const std::string verdict = verdicts.word(row, "verdict"), quantity = verdicts.word(row, "quantity"),
                      from = measured(quantity, verdicts.word(row, "conditional")),
                      to = measured(quantity, verdicts.word(row, "conditional_upper"));
    const bool plain = verdict == "reproduced" || verdict == "by definition";
    return (plain ? verdict : "**" + escaped(verdict) + "**") +
           (from.empty() ? "" : " (then " + from + (to.empty() ? "" : " to " + to) + ")");
}

/// \throws FailedComputation where the verdict in this row is on another claim
std::string claim_row(const Reproduction& reproduction, std::size_t row) {
    const auto& [paper, equations, claims, verdicts] = reproduction;
    const auto word = [&, &table = claims](const char* column) { return table.word(row, column); };
    const std::string id = word("id");
    if (row >= verdicts.rows.size() || verdicts.word(row, "id") != id)
        throw FailedComputation("claim " + id + " has no verdict yet; run make claims");
    return report::row(
        {"\\anchor " + anchor("claim", id) + " \\ref " + anchor_of_test(word("test")) + " \"" + id + "\"",
         claim_in_words(reproduction, row), verdict_in_words(verdicts, row),
         linked(word("quantity"), equations) + ": " + escaped(verdicts.word(row, "statement")) + " (" +
             escaped(word("reason")) + ")",
         measured(word("quantity"), verdicts.word(row, "measured_" + paper.conventions.one.name)),
         measured(word("quantity"), verdicts.word(row, "measured_" + paper.conventions.other.name)),
         word("old_id")});
}

std::string claims_of(const Reproduction& reproduction) {
    const auto& [paper, equations, claims, verdicts] = reproduction;
    const auto& [about, one, other] = paper.conventions;
    std::map<std::string, std::string> sections;
    for (std::size_t row = 0; row < claims.rows.size(); ++row)
        sections[claims.word(row, "section")] += claim_row(reproduction, row);
    std::string text = "## " + paper.citation + "\n\nThe two conventions: " + one.name + ", " +
                       one.condition + "; " + other.name + ", " + other.condition + ".\n\n";
    for (const auto& [section, rows] : sections)
        text += "### Section " + section + ": " + in_brief(report::tally(verdicts, section)) +
                "\n\n\\anchor " + anchor("claims", paper.letter + "-" + section) + "\n\n" +
                head({"claim", "says", "verdict", "measured quantity: what it must be (why so close)",
                      one.name, other.name, "old id"}) +
                rows + "\n";
    return text;
}

// What the print leaves open

/// The same quantities with one choice and with another, a table for each pair of choices.
std::string choices_of(const Paper& paper, const Table& choices) {
    std::string text = "\n## " + paper.citation + "\n\nThe \\ref companion_" + paper.folder +
                       " \"companion\" says what we chose and why.\n";
    std::string current;
    for (std::size_t row = 0; row < choices.rows.size(); ++row) {
        const auto word = [&](const char* column) { return escaped(choices.word(row, column)); };
        if (const std::string choice = word("choice"); choice != current) {
            text +=
                "\n### " + choice + "\n\n" + head({"quantity", "formulation", word("one"), word("other")});
            current = choice;
        }
        text += report::row({word("quantity"), word("formulation"), word("with_one"), word("with_other")});
    }
    return text;
}

// What the tests state

std::vector<std::string> test_files() {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator("tests"))
        if (entry.path().string().ends_with("_test.cpp")) files.push_back(entry.path().generic_string());
    std::sort(files.begin(), files.end());
    return files;
}

// What headings and search know

std::string quoted(const std::string& text) {
    return "\"" + replaced(replaced(text, "\\", "\\\\"), "\"", "\\\"") + "\"";
}

/// An object of JavaScript: a column of the reproductions' tables by another, the key
std::string object(const std::string& name, const std::vector<Reproduction>& all, Table Reproduction::*of,
                   const std::string& key, const std::string& column) {
    std::string text = "const " + name + " = {\n";
    for (const Reproduction& reproduction : all) {
        const Table& table = reproduction.*of;
        for (std::size_t row = 0; row < table.rows.size(); ++row)
            text += quoted(table.word(row, key)) + ": " + quoted(table.word(row, column)) + ",\n";
    }
    return text + "};\n";
}

// The generated parts of README.md and of doc/reproduction.md

/// A link from doc/ to a file or folder by its path from the top folder.
std::string link(const std::string& path) {
    return "[" + std::filesystem::path(path).filename().string() + "](../" + path + ")";
}

std::string links(const std::string& paths) {
    std::string all;
    std::istringstream words(paths);
    for (std::string path; words >> path;) all += (all.empty() ? "" : ", ") + link(path);
    return all;
}

}  // namespace

std::vector<Reproduction> reproductions() {
    const auto papers = report::papers(table_of("paper/papers.csv"));
    const auto equations = by_paper(table_of("paper/equations.csv"), papers);
    const auto claims = by_paper(table_of("paper/claims.csv"), papers);
    std::vector<Reproduction> all;
    for (const Paper& paper : papers) {
        const Table &its_equations = equations.at(paper.folder), &its_claims = claims.at(paper.folder);
        const std::string verdicts = "data/" + paper.folder + "/claims.csv";
        if (std::filesystem::exists(verdicts))
            all.push_back({paper, its_equations, its_claims, table_of(verdicts)});
        else if (!its_equations.rows.empty() || !its_claims.rows.empty())
            throw FailedComputation(verdicts + " is missing; run make claims");
    }
    return all;
}

std::string equation_page(const std::vector<Reproduction>& all) {
    std::string page =
        "Equations {#equations}\n=========\n\nEvery numbered equation, with the code that stands below it, the tests that name it, and the verdicts on what is claimed about it.\n";
    for (const Reproduction& reproduction : all) page += equations_of(reproduction);
    return page;
}

std::string claims_page(const std::vector<Reproduction>& all) {
    std::string page =
        "Claims {#claims}\n======\n\nEvery statement of a paper that a measurement can confirm or refute, in our words. Each verdict is computed: the statement is compared with what was measured under two conventions between which the print does not decide. The name of a claim leads to the tests of its subject.\n\n"
        "A text of our own has statements, too: they were predicted, and measured after that, in the plane and in space. They are counted apart.\n\n"
        "- **reproduced**: it holds under both conventions.\n"
        "- **holds only if**: it does not hold as it stands, but with the condition that the verdict names, or under one convention alone. The number that follows was measured with the condition. A misprint that one sign or one entry mends is a condition.\n"
        "- **differs**: it holds under neither, nor with the conditions that were tried, which the verdict names.\n"
        "- **by definition**: it follows from a definition and tests nothing. It is not counted.\n"
        "- The layout of the particles around the hole is lost. A statement about it is reproduced if it is true on each of 25 layouts of as many particles; it holds under a condition if it is true on some of them, or if the printed number lies between the least and the largest of theirs.\n"
        "- The old id is the name that the claim had before names said the section.\n\n";
    for (const Reproduction& reproduction : all) page += claims_of(reproduction);
    return page;
}

std::string choices_page(const std::vector<Reproduction>& all) {
    std::string page = "Choices {#choices}\n=======\n\nWhat the print leaves open, measured both ways.\n";
    for (const Reproduction& reproduction : all)
        if (const std::string choices = "data/" + reproduction.paper.folder + "/choices.csv";
            std::filesystem::exists(choices))
            page += choices_of(reproduction.paper, table_of(choices));
    return page;
}

std::string tests_page(const std::vector<Reproduction>& all) {
    std::string page =
        "Tests {#tests}\n=====\n\nWhat the tests of each file state. `make check` runs them all.\n\n";
    for (const std::string& path : test_files()) {
        const std::string file = path.substr(std::string("tests/").size());
        page += "\\section " + anchor_of_test(file) + " " + file + "\n";
        const Reproduction* reproduction = reproduction_in(file.substr(0, file.find('/')), all);
        for (const std::string& name : test_cases(read_whole(path)))
            page += "- " + (reproduction ? linked(name, reproduction->equations) : escaped(name)) + "\n";
        page += "\n";
    }
    return page;
}

std::string landmarks(const std::vector<Reproduction>& all) {
    return object("equations", all, &Reproduction::equations, "equation", "meaning") +
           object("claims", all, &Reproduction::claims, "id", "claim");
}

std::string sentence(const std::vector<Reproduction>& all, bool own) {
    Tally tally;
    for (const Reproduction& reproduction : all)
        if (reproduction.paper.own == own) tally = tally + report::tally(reproduction.verdicts);
    return in_a_sentence(tally, own) + "\n";
}

std::string items(const std::vector<Reproduction>& all) {
    const Table table = table_of("paper/items.csv");
    std::string text = head({"paper", "command", "output", "source", "claims"});
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto word = [&](const char* column) { return table.word(row, column); };
        const Reproduction* reproduction = reproduction_in(word("paper"), all);
        if (!reproduction)
            throw FailedComputation("'" + word("item") + "' of paper/items.csv is of no paper");
        text += report::row({word("item"), "`" + word("command") + "`", links(word("output")),
                             link(word("source")),
                             in_brief(report::tally(reproduction->verdicts, word("section")))});
    }
    return text;
}

}  // namespace report
