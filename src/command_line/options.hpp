#pragma once

#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/choose.hpp"
#include "base/quad.hpp"
#include "command_line/command_line.hpp"
#include "command_line/lists.hpp"
#include "command_line/plot.hpp"
#include "report/table.hpp"

/// What the programs share: they read options, call a section and write a table.
namespace command_line {

/// Calls `work(Scalar())` with the scalar of a precision: double, long (double) or quad.
/// \throws base::InvalidInput for another name
template <class Work>
auto in_precision(const std::string& name, const Work& work) {
    using Zero = std::variant<double, long double, base::Quad>;
    const Zero zero = of_option("--precision", [&] {
        return base::choose<Zero>("precision", name,
                                  {{"double", 0.0}, {"long", 0.0L}, {"quad", base::Quad(0)}});
    });
    return std::visit(work, zero);
}

/// Whether `--output` leads to the standard output.
bool is_standard_output(const std::string& output);

/// Refuses options that name the same file, since one would overwrite the other. Devices may be shared.
/// \param files options with the files that they name \throws base::InvalidInput
void check_apart(const std::vector<std::pair<std::string, std::string>>& files);

/// The body of main for a table: reads the options, computes the table, writes it and draws it. An incomplete
/// table is written and drawn; then the program fails with its reason.
/// \param threads how many, 0 for all \param output the file to write \param figure what to draw of the
///        table; all three have their values once the options are read
/// \return 0; 2 for a bad invocation; 1 for a failed computation, with one line on standard error
int run(CommandLine& app, int argc, char** argv, const int& threads, const std::string& output,
        const Figure& figure, const std::function<report::Table()>& compute);

}  // namespace command_line
