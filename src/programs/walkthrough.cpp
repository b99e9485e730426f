#include "report/walkthrough.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "command_line/command_line.hpp"
#include "report/file.hpp"
#include "report/findings.hpp"
#include "report/markdown.hpp"

namespace {

using report::Reproduction;

/// A file with generated parts, as it is and as it must be.
struct Page {
    std::string path, text, fresh;
};

struct Part {
    std::string key, text;
};

Page page(const std::string& path, const std::vector<Part>& parts) {
    Page page{path, report::read_whole(path), {}};
    page.fresh = page.text;
    for (const auto& [key, text] : parts) page.fresh = report::with_part(page.fresh, key, text, path);
    return page;
}

void write_pages(const std::string& folder, const std::vector<Reproduction>& all) {
    std::filesystem::create_directories(folder);
    report::write_whole(folder + "/equations.md", report::equation_page(all));
    report::write_whole(folder + "/claims.md", report::claims_page(all));
    report::write_whole(folder + "/choices.md", report::choices_page(all));
    report::write_whole(folder + "/tests.md", report::tests_page(all));
    report::write_whole(folder + "/landmarks.js", report::landmarks(all));
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Writes the generated pages of the walkthrough, the count of verdicts into README.md, and what was found into the walkthrough's first page and doc/reproduction.md. It runs in the top folder.",
        "walkthrough", "Example: walkthrough --pages build/doc/pages");
    std::string pages, readme = "README.md", first_page = "doc/site/walkthrough.md",
                       reproduction = "doc/reproduction.md";
    bool write = false, check = false;
    app.add_option("--pages", pages, "folder to write the pages into").type_name("FOLDER");
    app.add_option("--readme", readme, "a file with the count of verdicts (default README.md)")
        .type_name("FILE");
    app.add_option("--first-page", first_page, "a file with what was found (default doc/site/walkthrough.md)")
        .type_name("FILE");
    app.add_option(
           "--reproduction", reproduction,
           "a file with what was found and the table of the papers' items (default doc/reproduction.md)")
        .type_name("FILE");
    app.add_flag("--write", write, "write the generated parts of these files anew");
    app.add_flag("--check", check, "fail where a generated part is stale");
    return command_line::run(app, argc, argv, [&] {
        const std::vector<Reproduction> all = report::reproductions();
        if (!pages.empty()) write_pages(pages, all);
        if (!write && !check) return 0;
        const Part count{"count", report::with_numbers("{verdicts}\n", all)},
            summary{"summary", report::with_numbers(report::read_whole("paper/findings.txt"), all)},
            table{"table", report::items(all)};
        for (const Page& each :
             {page(readme, {count}), page(first_page, {summary}), page(reproduction, {summary, table})}) {
            if (each.fresh == each.text) continue;
            if (!write) throw base::FailedComputation(each.path + " is stale; run make claims");
            report::write_whole(each.path, each.fresh);
        }
        return 0;
    });
}
