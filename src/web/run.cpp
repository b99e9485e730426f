#include <emscripten.h>

#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

// The programs of the pages that compute. make/live.mk compiles each one's main under a name of its own.
int derivative_test_main(int argc, char** argv);
int static_test_main(int argc, char** argv);
int vibration_test_main(int argc, char** argv);
int stencil_main(int argc, char** argv);
int derivative_test_in_space_main(int argc, char** argv);

/// What a program says on the standard error, as far as it has come. The page may give a function `told`.
EM_JS(void, tell, (const char* text), {
    if (Module.told) Module.told(UTF8ToString(text));
});

namespace {

/// The standard error, which is told whenever it is flushed: progress and messages.
struct Told : std::stringbuf {
    int sync() override {
        tell(str().c_str());
        str("");
        return 0;
    }
};

}  // namespace

/// Runs a program of the package as a shell would.
/// \param command its name and arguments, each ended by a line break
/// \return its exit code
extern "C" EMSCRIPTEN_KEEPALIVE int run(const char* command) {
    static const std::map<std::string, int (*)(int, char**)> programs{
        {"derivative_test", derivative_test_main},
        {"static_test", static_test_main},
        {"vibration_test", vibration_test_main},
        {"stencil", stencil_main},
        {"derivative_test_in_space", derivative_test_in_space_main}};
    Told told;
    std::streambuf* const before = std::cerr.rdbuf(&told);
    std::istringstream lines(command);
    std::vector<std::string> words;
    for (std::string word; std::getline(lines, word);) words.push_back(word);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int code = programs.at(words.at(0))(static_cast<int>(words.size()), argv.data());
    std::cout.flush();
    std::cout.clear();
    std::cerr.rdbuf(before);
    return code;
}
