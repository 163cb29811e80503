#include "calib/work/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "calib/work/error.h"
#include "calib/work/unfinished_sibling.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_read(const fs::path& path, const std::string& reason) {
    throw Error(ErrorKind::kBadInput, "E-FILE-READ", path.string() + ": " + reason,
                "check that the file exists and that you may read it");
}

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Throws for `path` unless files can be made in `folder`, or it in the nearest one that exists.
void require_room_in(const fs::path& folder, const fs::path& path) {
    std::error_code status;
    fs::path nearest = fs::absolute(folder, status);
    if (status) refuse_write(path, status.value());
    while (!fs::exists(nearest, status) && nearest.has_relative_path())
        nearest = nearest.parent_path();
    if (!fs::is_directory(nearest, status)) refuse_write(path, ENOTDIR);
    if (::access(nearest.c_str(), W_OK | X_OK) != 0) refuse_write(path, errno);
}

/// A temporary file beside its target that vanishes unless it is renamed into place.
class TemporarySibling {
 public:
    explicit TemporarySibling(const fs::path& target)
        : target_(target), path_(make_unfinished_sibling(target, [this](const char* path) {
              return descriptor_ = ::open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
          })) {}
    ~TemporarySibling() {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (!renamed_) ::unlink(path_.c_str());
    }
    TemporarySibling(const TemporarySibling&) = delete;
    TemporarySibling& operator=(const TemporarySibling&) = delete;

    void write(std::span<const std::uint8_t> bytes) const {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) refuse_write(target_, errno);
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
    }

    void rename_into_place() {
        if (::fsync(descriptor_) != 0) refuse_write(target_, errno);
        const int closed = ::close(descriptor_);
        descriptor_ = -1;
        if (closed != 0) refuse_write(target_, errno);
        if (::rename(path_.c_str(), target_.c_str()) != 0) refuse_write(target_, errno);
        renamed_ = true;
    }

 private:
    int descriptor_ = -1;
    fs::path target_;
    fs::path path_;
    bool renamed_ = false;
};

}  // namespace

void refuse_write(const fs::path& path, int error_number) {
    const bool full = error_number == ENOSPC || error_number == EDQUOT || error_number == EFBIG;
    throw Error(full ? ErrorKind::kResources : ErrorKind::kBadInput, "E-FILE-WRITE",
                path.string() + ": cannot write: " + std::strerror(error_number),
                full ? "free some disk space and run the same command again"
                     : "check that the folder exists and that you may write there");
}

void remove_unfinished_siblings(const fs::path& path) {
    std::vector<fs::path> unfinished;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(path), ignored)) {
        const bool is_file = entry.symlink_status(ignored).type() == fs::file_type::regular;
        if (is_file && entry.path().filename().string().starts_with(unfinished_prefix(path)))
            unfinished.push_back(entry.path());
    }
    for (const fs::path& sibling : unfinished) fs::remove(sibling, ignored);
}

void flush_folder(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);  // Not every file system can; the rename itself is done either way.
    ::close(descriptor);
}

Bytes read_whole_file(const fs::path& path, std::size_t max_bytes) {
    std::error_code status;
    const fs::file_status found = fs::status(path, status);
    if (!fs::status_known(found)) refuse_read(path, status.message());
    if (!fs::exists(found)) refuse_read(path, "there is nothing at this path");
    if (!fs::is_regular_file(found)) refuse_read(path, "not a file");
    const std::uintmax_t size = fs::file_size(path, status);
    if (status) refuse_read(path, status.message());
    if (size > max_bytes) {
        throw Error(ErrorKind::kBadInput, "E-FILE-TOOBIG",
                    path.string() + ": " + std::to_string(size) + " bytes, expected at most " +
                        std::to_string(max_bytes),
                    "this does not look like the file that was meant");
    }
    std::ifstream stream(path, std::ios::binary);
    Bytes bytes(static_cast<std::size_t>(size));
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!stream || static_cast<std::uintmax_t>(stream.gcount()) != size) {
        refuse_read(path, "cannot be read to its end");
    }
    return bytes;
}

std::string read_whole_text(const fs::path& path, std::size_t max_bytes) {
    const Bytes bytes = read_whole_file(path, max_bytes);
    const auto* begin = reinterpret_cast<const char*>(bytes.data());
    return std::string(without_byte_order_mark({begin, bytes.size()}));
}

std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    return text;
}

void write_whole_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
    const fs::path folder = folder_of(path);
    std::error_code status;
    fs::create_directories(folder, status);
    if (status) refuse_write(path, status.value());

    TemporarySibling temporary(path);
    temporary.write(bytes);
    temporary.rename_into_place();
    flush_folder(folder);
}

void require_writable_file(const fs::path& path) {
    std::error_code status;
    if (!path.has_filename() || fs::is_directory(path, status)) refuse_write(path, EISDIR);
    require_room_in(folder_of(path), path);
}

void require_writable_folder(const fs::path& folder) { require_room_in(folder, folder); }

void put_whole_file(const fs::path& made, const fs::path& path) {
    const int descriptor = ::open(made.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) refuse_write(path, errno);
    const int flushed = ::fsync(descriptor);
    const int reason = errno;
    ::close(descriptor);
    if (flushed != 0) refuse_write(path, reason);
    if (::rename(made.c_str(), path.c_str()) != 0) refuse_write(path, errno);
    flush_folder(folder_of(path));
}

void write_whole_text(const fs::path& path, std::string_view text) {
    write_whole_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace lumi
