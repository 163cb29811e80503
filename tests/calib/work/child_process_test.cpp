#include "calib/work/child_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

class ChildProcess : public testing::Test {
 protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() /
                  ("lumi_child_" + std::to_string(::getpid()) + "_" +
                   testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    ChildCommand shell(const std::string& script) const {
        ChildCommand command;
        command.arguments = {"/bin/sh", "-c", script};
        command.log_path = folder_ / "log.txt";
        return command;
    }
    std::string log() const { return read_whole_text(folder_ / "log.txt"); }

    /// True when the process is gone within two seconds: dying takes the kernel a moment.
    static bool is_gone(pid_t process) {
        for (int attempt = 0; attempt < 200; ++attempt) {
            if (::kill(process, 0) != 0) return true;
            const fs::path status = "/proc/" + std::to_string(process) + "/stat";
            std::error_code missing;
            if (!fs::exists(status, missing)) return true;
            if (read_stat(status).find(") Z ") != std::string::npos) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }
    static std::string read_stat(const fs::path& path) {
        std::FILE* file = std::fopen(path.c_str(), "r");
        if (file == nullptr) return ") Z ";
        std::string text(512, '\0');
        text.resize(std::fread(text.data(), 1, text.size(), file));
        std::fclose(file);
        return text;
    }

    fs::path folder_;
    SilentProgress progress_;
};

TEST_F(ChildProcess, CapturesBothOutputsAndTheExitStatus) {
    const ChildResult result = run_child(shell("echo seen; echo heard >&2; exit 3"), progress_);
    EXPECT_EQ(result.end, ChildEnd::kExited);
    EXPECT_EQ(result.exit_status, 3);
    EXPECT_EQ(log(), "seen\nheard\n");
}

TEST_F(ChildProcess, HandsOutputOnAsItComes) {
    std::string received;
    ChildCommand command = shell("echo one; echo two");
    command.on_output = [&](std::string_view text) { received += text; };
    static_cast<void>(run_child(command, progress_));
    EXPECT_EQ(received, "one\ntwo\n");
}

TEST_F(ChildProcess, PassesArgumentsWithoutAShell) {
    ChildCommand command;
    command.arguments = {"printf", "%s|", "a b", "$(x)", "*"};
    command.log_path = folder_ / "log.txt";
    static_cast<void>(run_child(command, progress_));
    EXPECT_EQ(log(), "a b|$(x)|*|");
}

TEST_F(ChildProcess, ReportsTheSignal) {
    const ChildCommand command = shell("kill -ABRT $$");
    const ChildResult result = run_child(command, progress_);
    EXPECT_EQ(result.end, ChildEnd::kSignalled);
    EXPECT_EQ(result.signal, SIGABRT);
    EXPECT_EQ(description_of(result, command), "signal 6 (Aborted)");
}

TEST_F(ChildProcess, TimeLimitKillsGrandchildren) {
    ChildCommand command = shell("sleep 60 & echo $!; wait");
    command.time_limit_s = 0.4;
    const ChildResult result = run_child(command, progress_);
    EXPECT_EQ(result.end, ChildEnd::kTimeLimit);
    EXPECT_LT(result.wall_s, 5.0);
    EXPECT_TRUE(is_gone(std::stoi(log())));
}

TEST_F(ChildProcess, GrandchildrenDoNotOutliveAnOrdinaryEnd) {
    static_cast<void>(run_child(shell("sleep 60 & echo $!"), progress_));
    EXPECT_TRUE(is_gone(std::stoi(log())));
}

TEST_F(ChildProcess, SilenceLimitEndsAProgramThatSpins) {
    ChildCommand command = shell("echo begun; while :; do :; done");
    command.silence_limit_s = 0.4;
    const ChildResult result = run_child(command, progress_);
    EXPECT_EQ(result.end, ChildEnd::kSilenceLimit);
    EXPECT_GT(result.cpu_s, 0.05);
}

TEST_F(ChildProcess, InterruptionKillsTheGroup) {
    std::thread user([this] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        progress_.interrupt();
    });
    const auto run = [&] { return run_child(shell("sleep 60 & echo $!; wait"), progress_); };
    try {
        static_cast<void>(run());
        ADD_FAILURE() << "expected an interruption";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-INTERRUPTED");
    }
    user.join();
    EXPECT_TRUE(is_gone(std::stoi(log())));
}

TEST_F(ChildProcess, EndsWhereTheSignalOfEndedChildrenIsIgnored) {
    const auto before = ::signal(SIGCHLD, SIG_IGN);
    ChildCommand command = shell("grep SigIgn /proc/self/status; exit 3");
    command.time_limit_s = 10;
    const ChildResult result = run_child(command, progress_);
    ::signal(SIGCHLD, before);
    EXPECT_EQ(result.end, ChildEnd::kExited);
    EXPECT_EQ(result.exit_status, 3);
    const std::uint64_t ignored = std::stoull(log().substr(log().find_last_of(" \t")), nullptr, 16);
    EXPECT_EQ(ignored >> (SIGCHLD - 1) & 1, 0U);
}

TEST_F(ChildProcess, AHandlerOfEndedChildrenStays) {
    const auto handler = +[](int) {};
    const auto before = ::signal(SIGCHLD, handler);
    static_cast<void>(run_child(shell("exit 0"), progress_));
    EXPECT_EQ(::signal(SIGCHLD, before), handler);
}

TEST_F(ChildProcess, IsLostWhenSomebodyElseWaitsForIt) {
    ChildCommand command = shell("echo $$; exec sleep 60");
    command.on_output = [](std::string_view text) {
        if (text.empty()) return;
        const pid_t child = std::stoi(std::string(text));
        ::kill(child, SIGKILL);
        EXPECT_EQ(::waitpid(child, nullptr, 0), child);
    };
    try {
        static_cast<void>(run_child(command, progress_));
        ADD_FAILURE() << "expected an error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-CHILD-LOST");
        EXPECT_THAT(error.what(), testing::HasSubstr("/bin/sh"));
    }
}

TEST_F(ChildProcess, MissingProgramIsNamedWithAdvice) {
    ChildCommand command;
    command.arguments = {"no-such-program-lumi"};
    command.log_path = folder_ / "log.txt";
    command.missing_advice = "install it";
    try {
        static_cast<void>(run_child(command, progress_));
        ADD_FAILURE() << "expected an error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-CHILD-MISSING");
        EXPECT_EQ(error.kind(), ErrorKind::kExternalProgram);
        EXPECT_THAT(error.what(), testing::HasSubstr("no-such-program-lumi"));
        EXPECT_EQ(error.advice(), "install it");
    }
}

TEST_F(ChildProcess, IsFoundBehindFoldersOfThePathThatCannotBeReached) {
    // A path longer than any can be is as unreachable to root as a closed folder is to others.
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", ("/" + std::string(5000, 'x') + ":" + path).c_str(), 1);
    ChildCommand command;
    command.arguments = {"true"};
    command.log_path = folder_ / "log.txt";
    EXPECT_EQ(run_child(command, SilentProgress()).exit_status, 0);
    ::setenv("PATH", path.c_str(), 1);
}

TEST_F(ChildProcess, HasNoDisplay) {
    ::setenv("DISPLAY", ":77", 1);
    static_cast<void>(run_child(shell("echo \"[$DISPLAY] $QT_QPA_PLATFORM\""), progress_));
    ::unsetenv("DISPLAY");
    EXPECT_EQ(log(), "[] offscreen\n");
}

TEST(CommandLine, QuotesWhatAShellWouldSplit) {
    EXPECT_EQ(command_line_of({"colmap", "a b", "it's", ""}), "colmap 'a b' 'it'\\''s' ''");
}

}  // namespace
}  // namespace lumi
