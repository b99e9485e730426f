#include <filesystem>
#include <string>
#include <vector>

#include "tests/programs/run.hpp"

using programs::run;

namespace {

/// Runs walkthrough in a copy of the project in which a shell command has changed something.
programs::Outcome in_changed_copy(const std::string& change, const std::string& options) {
    const programs::Folder folder;
    const std::string copy =
        "cp -r paper tests data doc README.md '" + folder.path + "' && cd '" + folder.path + "' && ";
    return run("sh -c \"" + copy + change + " && walkthrough " + options + "\"");
}

/// A project of two papers whose sections have the same numbers; the second numbers its equations with a dot.
struct TwoPapers : programs::Folder {
    TwoPapers() {
        write("paper/papers.csv",
              "letter,paper,citation,own,conventions,one,if_one,other,if_other\n"
              "A,first,First (1901),,volumes,equal,volumes are equal,partition,volumes tile\n"
              "B,second,Second (1902),,error,dn,E is a difference,nd,E is a norm\n"
              "C,third,Third (1903),yes,error,dn,E is a difference,nd,E is a norm\n");
        write("paper/equations.csv",
              "equation,section,meaning,code,test\n"
              "A2,2,a sum,first/section_2_sums.hpp,first/sums_test.cpp\n"
              "B2.1,2.1,a basis,second/section_2_1_basis.hpp,second/basis_test.cpp\n"
              "B2.10,2.1,its order,second/section_2_1_basis.hpp,second/basis_test.cpp\n");
        write(
            "paper/claims.csv",
            "id,old_id,section,equations,kind,claim,quantity,relation,expected,tolerance,reason,test\n"
            "A-2-sum,A01,2,2,,(2) is exact and (2.1) a number,an error,<,1,0,a reason,first/sums_test.cpp\n"
            "B-2-basis,B01,2,2.10,,(2.1) is exact and (2.5) a number,an error,<,1,0,a reason,second/basis_test.cpp\n");
        write("paper/items.csv",
              "paper,item,section,command,output,source\n"
              "first,Sums,2,make check,a.csv,a.hpp\nsecond,Basis,2,make check,b.csv,b.hpp\n");
        write(
            "data/first/claims.csv",
            "id,quantity,statement,measured_equal,measured_partition,conditional,conditional_upper,section,verdict\n"
            "A-2-sum,an error,< 1,0.5,0.25,,,2,reproduced\n");
        write("data/second/claims.csv",
              "id,quantity,statement,measured_dn,measured_nd,conditional,conditional_upper,section,verdict\n"
              "B-2-basis,an error,< 1,1.5,1.25,,,2,differs\n");
        write("data/second/choices.csv",
              "choice,one,other,quantity,formulation,with_one,with_other\nerror,dn,nd,E,basis,1,2\n");
        write("tests/first/sums_test.cpp", "TEST_CASE(\"sums: (2)\") {}\n");
        write("tests/second/basis_test.cpp", "TEST_CASE(\"basis: (2.1), (2.10) and (2)\") {}\n");
        write("README.md", generated("count"));
        write("doc/site/walkthrough.md", generated("summary"));
        write("paper/findings.txt", "- {verdicts} The error is {B-2-basis}, {count A-2} sums.\n");
        write("doc/reproduction.md", generated("summary") + generated("table"));
    }

    static std::string generated(const std::string& part) {
        return "<!-- the " + part + " below is written by make claims -->\n<!-- end of the " + part +
               " -->\n";
    }

    void write(const std::string& file, const std::string& text) const {
        std::filesystem::create_directories(std::filesystem::path(path + "/" + file).parent_path());
        report::write_whole(path + "/" + file, text);
    }

    [[nodiscard]] std::string read(const std::string& file) const {
        return report::read_whole(path + "/" + file);
    }

    [[nodiscard]] programs::Outcome walkthrough() const {
        return run("cd '" + path + "' && walkthrough --pages pages --write");
    }
};

/// Does a text hold all these parts, one behind the other?
bool in_order(const std::string& text, const std::vector<std::string>& parts) {
    std::size_t at = 0;
    for (const std::string& part : parts) {
        at = text.find(part, at);
        if (at == std::string::npos) return false;
        at += part.size();
    }
    return true;
}

}  // namespace

TEST_CASE("walkthrough: every equation is indexed, and pages are written for equations, claims and tests") {
    const auto [code, output, errors] = in_changed_copy(
        "true", "--pages pages && grep -c '^| .*anchor index_[AB][0-9]' pages/equations.md && ls pages");
    CHECK(code == 0);
    CHECK(errors.empty());
    CHECK(output == "104\nchoices.md\nclaims.md\nequations.md\nlandmarks.js\ntests.md\n");
}

TEST_CASE("walkthrough: a claim without a verdict is red") {
    const auto [code, output, errors] =
        in_changed_copy("sed -i '/^A-5.1-perturbed,/d' data/asprone2010/claims.csv", "--pages pages");
    CHECK(code == 1);
    CHECK(errors.find("has no verdict yet; run make claims") != std::string::npos);
}

TEST_CASE("walkthrough: a stale count, summary or table is found, and written anew") {
    CHECK(in_changed_copy("true", "--check").code == 0);
    for (const std::string file : {"README.md", "doc/site/walkthrough.md", "doc/reproduction.md"}) {
        const std::string stale = "sed -i 's/ reproduced/ refuted/' " + file;
        const auto found = in_changed_copy(stale, "--check");
        CHECK(found.code == 1);
        CHECK(found.errors.find(file + " is stale; run make claims") != std::string::npos);
        CHECK(in_changed_copy(stale, "--write && walkthrough --check").code == 0);
    }
}

TEST_CASE("walkthrough: pages are divided by paper, though sections have equal numbers") {
    const TwoPapers project;
    const auto [code, output, errors] = project.walkthrough();
    CHECK(errors.empty());
    CHECK(code == 0);
    CHECK(in_order(
        project.read("pages/equations.md"),
        {"## First (1901)", "\\anchor index_A2 \\eq{A2} | \\ref first::sums \"2\"", "\\claim{A-2-sum}",
         "## Second (1902)", "\\anchor index_B2_1 \\eq{B2.1} | \\ref second::basis \"2.1\"",
         "\"tests\" |  |\n", "\\anchor index_B2_10 \\eq{B2.10}", "\\claim{B-2-basis}"}));
    CHECK(in_order(project.read("pages/claims.md"),
                   {"## First (1901)", "equal, volumes are equal; partition, volumes tile",
                    "### Section 2: 1 of 1 reproduced", "\\anchor claims_A-2\n", "| equal | partition |",
                    "\\anchor claim_A-2-sum ", "| 0.5 | 0.25 | A01 |", "## Second (1902)",
                    "### Section 2: 0 of 1 reproduced, 1 differs", "| dn | nd |", "| 1.5 | 1.25 |"}));
    CHECK(in_order(project.read("pages/choices.md"), {"## Second (1902)", "companion_second", "### error"}));
    const std::string count =
        "Of the papers' 2 testable statements, 1 is reproduced, 0 hold under a condition, and 1 differs.";
    CHECK(in_order(project.read("README.md"), {"-->\n" + count + "\n<!--"}));
    const std::string summary = "- " + count + " The error is 1.5, all 1 sums.\n";
    CHECK(in_order(project.read("doc/site/walkthrough.md"), {summary}));
    CHECK(in_order(project.read("doc/reproduction.md"), {summary, "| Sums |", "[a.csv](../a.csv)",
                                                         "1 of 1 reproduced", "| Basis |", "1 differs"}));
    for (const char* page : {"equations", "claims", "choices"})
        CHECK(project.read(std::string("pages/") + page + ".md").find("Third") == std::string::npos);
}

TEST_CASE("walkthrough: headings and search know what each equation and each claim says") {
    const TwoPapers project;
    project.write("paper/equations.csv",
                  "equation,section,meaning,code,test\n"
                  "A2,2,a sum,first/section_2_sums.hpp,first/sums_test.cpp\n"
                  "B2.1,2.1,\"a \"\"basis\"\" \\phi\",second/section_2_1_basis.hpp,second/basis_test.cpp\n");
    CHECK(project.walkthrough().code == 0);
    CHECK(project.read("pages/landmarks.js") ==
          "const equations = {\n\"A2\": \"a sum\",\n\"B2.1\": \"a \\\"basis\\\" \\\\phi\",\n};\n"
          "const claims = {\n\"A-2-sum\": \"(2) is exact and (2.1) a number\",\n"
          "\"B-2-basis\": \"(2.1) is exact and (2.5) a number\",\n};\n");
}

TEST_CASE("walkthrough: a number in brackets links to its paper's equation, if there is one") {
    const TwoPapers project;
    CHECK(project.walkthrough().code == 0);
    const std::string claims = project.read("pages/claims.md");
    CHECK(claims.find("| \\eq{A2} is exact and (2.1) a number |") != std::string::npos);
    CHECK(claims.find("| \\eq{B2.1} is exact and (2.5) a number \\eq{B2.10} |") != std::string::npos);
    const std::string tests = project.read("pages/tests.md");
    CHECK(tests.find("- sums: \\eq{A2}\n") != std::string::npos);
    CHECK(tests.find("- basis: \\eq{B2.1}, \\eq{B2.10} and (2)\n") != std::string::npos);
}

TEST_CASE("walkthrough: a paper with rows but without verdicts is red, and so is an item of no paper") {
    const TwoPapers project;
    std::filesystem::remove(project.path + "/data/second/claims.csv");
    CHECK(project.walkthrough().errors ==
          "walkthrough: data/second/claims.csv is missing; run make claims\n");
    const TwoPapers with_item;
    with_item.write("paper/items.csv", "paper,item,section,command,output,source\nthird,Item,2,make,a,b\n");
    CHECK(with_item.walkthrough().errors == "walkthrough: 'Item' of paper/items.csv is of no paper\n");
}
