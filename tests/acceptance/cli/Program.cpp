// SPDX-License-Identifier: MIT
#include "tests/acceptance/cli/Program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "core/common/Files.h"

extern char** environ;

namespace fodscope::test {

TestFolder::TestFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "fodscope-test-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder for the test");
    path_ = pattern;
}

TestFolder::~TestFolder() {
    std::error_code code;
    std::filesystem::remove_all(path_, code);
}

Program::Program(const std::vector<std::string>& arguments) {
    std::vector<std::string> words{FODSCOPE_CLI};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    const std::string out = (folder_ / "out").string();
    const std::string err = (folder_ / "err").string();
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int failed = posix_spawn(&process_, FODSCOPE_CLI, &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) throw std::runtime_error("fodscope-cli does not start");
}

Program::~Program() {
    if (ended_) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, &status_, 0);
}

void Program::interrupt() const {
    ::kill(process_, SIGINT);
}

bool Program::hearsInterrupts() const {
    std::ifstream status("/proc/" + std::to_string(process_) + "/status");
    for (std::string line; std::getline(status, line);) {
        if (!line.starts_with("SigBlk:")) continue;
        return ((std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1)) & 1U) != 0;
    }
    return false;
}

bool Program::isRunning() {
    if (!ended_) ended_ = ::waitpid(process_, &status_, WNOHANG) == process_;
    return !ended_;
}

Outcome Program::wait() {
    if (!ended_) ended_ = ::waitpid(process_, &status_, 0) == process_;
    return {WIFEXITED(status_) ? WEXITSTATUS(status_) : -1, readTextFile(folder_ / "out"),
            readTextFile(folder_ / "err")};
}

Outcome runCli(const std::vector<std::string>& arguments) {
    return Program(arguments).wait();
}

}  // namespace fodscope::test
