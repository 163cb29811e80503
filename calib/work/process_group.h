#pragma once

#include <sys/resource.h>
#include <sys/types.h>
#include <unistd.h>

#include <string>
#include <utility>
#include <vector>

namespace lumi {

/// An open file; closed when left behind.
class FileDescriptor {
 public:
    explicit FileDescriptor(int value) : value_(value) {}
    ~FileDescriptor() { reset(); }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
    [[nodiscard]] int get() const { return value_; }
    void reset() {
        if (value_ >= 0) ::close(value_);
        value_ = -1;
    }

 private:
    int value_;
};

/// A running program and all it starts; killed and reaped when it is left behind.
class ProcessGroup {
 public:
    /// Starts `program` (a path) as the leader of a group of its own, without a display and with
    /// nothing on standard input. Where this process ignores SIGCHLD it does so no longer: the end
    /// of a child would be lost. Throws Error (E-CHILD-START).
    [[nodiscard]] static ProcessGroup start(const std::string& program,
                                            std::vector<std::string> arguments,
                                            int output_descriptor);
    ~ProcessGroup() {
        if (!reaped_) kill_and_reap();
    }
    ProcessGroup(const ProcessGroup&) = delete;
    ProcessGroup& operator=(const ProcessGroup&) = delete;

    /// True when the leader has ended; what it left behind in its group is killed. Throws Error
    /// (E-CHILD-LOST) when somebody else has waited for it.
    [[nodiscard]] bool ended();
    void kill_and_reap();

    [[nodiscard]] int status() const { return status_; }  ///< As of wait(2), once it has ended.
    /// User and system time of the leader and of its own finished children.
    [[nodiscard]] double cpu_s() const;

 private:
    ProcessGroup(std::string program, pid_t leader)
        : program_(std::move(program)), leader_(leader) {}
    std::string program_;
    pid_t leader_;
    bool reaped_ = false;
    int status_ = 0;
    rusage usage_{};
};

}  // namespace lumi
