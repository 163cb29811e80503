#pragma once

#include <stdexcept>
#include <string>

namespace lumi {

/// What kind of "no" ended the work; its value is the exit code of the command line.
enum class ErrorKind {
    kUsage = 2,              ///< The command line or the configuration is wrong.
    kBadInput = 3,           ///< A file cannot be read or contradicts itself.
    kDegenerateCapture = 4,  ///< The photographs cannot tell what was asked of them.
    kPartialResult = 5,      ///< Something was made, but less than the stated share.
    kResources = 6,          ///< Disk or memory ran out.
    kExternalProgram = 7,    ///< A program that lumi drives failed.
    kInterrupted = 130,      ///< The user asked to stop.
};

/// An end that the user can do something about.
///
/// `code` is stable and greppable (`E-POSES-NOPAIR`), `what()` says what happened and where (file,
/// line or photograph) and what was expected, `advice` says what to do next.
class Error : public std::runtime_error {
 public:
    Error(ErrorKind kind, std::string code, const std::string& what_and_where, std::string advice)
        : std::runtime_error(what_and_where),
          kind_(kind),
          code_(std::move(code)),
          advice_(std::move(advice)) {}

    [[nodiscard]] ErrorKind kind() const { return kind_; }
    [[nodiscard]] const std::string& code() const { return code_; }
    [[nodiscard]] const std::string& advice() const { return advice_; }
    [[nodiscard]] int exit_code() const { return static_cast<int>(kind_); }

 private:
    ErrorKind kind_;
    std::string code_;
    std::string advice_;
};

/// In one line, for tables and lists of what failed: "E-CODE: what -> advice".
[[nodiscard]] inline std::string failure_text(const Error& failure) {
    return failure.code() + ": " + failure.what() + " -> " + failure.advice();
}

}  // namespace lumi
