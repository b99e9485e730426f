#include <string>

#include "asprone2010/choices.hpp"
#include "batra2008/choices.hpp"
#include "command_line/options.hpp"

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Measures how much the results change with each choice that a paper leaves open.", "choices",
        "Example: choices --paper batra2008 --output /tmp/choices.csv");
    std::string paper = "asprone2010", output;
    app.add_option("--paper", paper, "asprone2010 (default) or batra2008")
        .type_name("NAME")
        .among({"asprone2010", "batra2008"});
    app.add_output(output);
    return command_line::run(app, argc, argv, 0, output, {}, [&] {
        return paper == "batra2008" ? batra2008::choices() : asprone2010::choices();
    });
}
