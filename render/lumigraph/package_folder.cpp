#include "render/lumigraph/package_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "calib/work/content_hash.h"
#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "render/lumigraph/manifest.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNameThePackage = "name the folder that `lumi build` made; it ends in .lumi";

[[noreturn]] void refuse(const std::string& code, const fs::path& path, const std::string& what) {
    throw Error(ErrorKind::kBadInput, code, path.string() + ": " + what,
                "the package is damaged: copy it again, or build it again with `lumi build`");
}

/// For a value of errno: throws where the system keeps from reading what may well be whole, that
/// is, for all but what names say that lead nowhere.
void expect_access(const fs::path& path, int error_number) {
    const auto no_access = [&](ErrorKind kind, const std::string& advice) {
        return Error(kind, "E-PACKAGE-ACCESS",
                     path.string() + ": cannot be read: " + std::strerror(error_number), advice);
    };
    switch (error_number) {
        case ENOENT:
        case ENOTDIR:
        case ELOOP:
        case ENAMETOOLONG:
            return;
        case EACCES:
        case EPERM:
            throw no_access(ErrorKind::kBadInput,
                            "ask its owner to let you read all of the package (chmod -R a+rX)");
        case EMFILE:
        case ENFILE:
            throw no_access(ErrorKind::kResources,
                            "close other programs, or raise the limit of open files (ulimit -n)");
        case ENOMEM:
            throw no_access(ErrorKind::kResources, "close other programs");
        default:
            throw no_access(ErrorKind::kResources,
                            "the disk fails, or the network to it: copy the package to another");
    }
}

/// The same, and it throws for all else too.
[[noreturn]] void refuse_reading(const fs::path& path, int error_number) {
    expect_access(path, error_number);
    refuse("E-PACKAGE-MISSING", path,
           "cannot be read: " + std::string(std::strerror(error_number)));
}

/// An open file or folder that closes itself.
class Descriptor {
 public:
    explicit Descriptor(int value) : value_(value) {}
    ~Descriptor() {
        if (value_ >= 0) ::close(value_);
    }
    Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(value_, other.value_);
        return *this;
    }
    [[nodiscard]] int get() const { return value_; }

 private:
    int value_;
};

/// Opens `path` below `root` without following a link at any part. O_NONBLOCK keeps a pipe from
/// waiting for a writer.
Descriptor open_below(int root, std::string_view path, const fs::path& shown) {
    Descriptor current(::fcntl(root, F_DUPFD_CLOEXEC, 0));
    if (current.get() < 0) refuse_reading(shown, errno);
    while (true) {
        const std::size_t slash = path.find('/');
        const bool is_last = slash == std::string_view::npos;
        const std::string part(path.substr(0, slash));
        const int kind = is_last ? O_NONBLOCK : O_DIRECTORY;
        const int next =
            ::openat(current.get(), part.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | kind);
        // A link is ELOOP where a file was asked for and ENOTDIR where a folder was, a socket
        // ENXIO.
        if (next < 0 && (errno == ELOOP || errno == ENOTDIR || errno == ENXIO))
            refuse("E-PACKAGE-PATH", shown, "expected a plain file reached without a link");
        if (next < 0) refuse_reading(shown, errno);
        current = Descriptor(next);
        if (is_last) return current;
        path.remove_prefix(slash + 1);
    }
}

std::uint64_t size_of_plain_file(const Descriptor& file, const fs::path& shown) {
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) refuse_reading(shown, errno);
    if (!S_ISREG(status.st_mode)) refuse("E-PACKAGE-PATH", shown, "expected a plain file");
    return static_cast<std::uint64_t>(status.st_size);
}

Bytes bytes_of(const Descriptor& file, std::uint64_t size, const fs::path& shown) {
    Bytes bytes(size);
    for (std::size_t offset = 0; offset < bytes.size();) {
        const ssize_t count = ::read(file.get(), bytes.data() + offset, bytes.size() - offset);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) refuse_reading(shown, errno);
        if (count == 0)
            refuse("E-PACKAGE-SIZE", shown, "is shorter than it was when it was opened");
        offset += static_cast<std::size_t>(count);
    }
    return bytes;
}

/// Names that some systems take for devices, whatever their ending.
bool names_device(std::string_view part) {
    constexpr std::array<std::string_view, 4> kDevices{"con", "prn", "aux", "nul"};
    const std::string_view stem = part.substr(0, part.find('.'));
    if (stem.size() == 4 && (stem.starts_with("com") || stem.starts_with("lpt"))) {
        return stem[3] >= '0' && stem[3] <= '9';
    }
    return std::find(kDevices.begin(), kDevices.end(), stem) != kDevices.end();
}

bool is_plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

}  // namespace

bool is_safe_package_path(std::string_view path) {
    constexpr std::size_t kMaxLength = 200;
    constexpr std::array<std::string_view, 4> kEndings{".png", ".ply", ".mesh", ".toml"};
    const auto* ending = std::find_if(kEndings.begin(), kEndings.end(),
                                      [&](std::string_view e) { return path.ends_with(e); });
    if (path.size() > kMaxLength || ending == kEndings.end()) return false;
    path.remove_suffix(ending->size());
    while (true) {
        const std::string_view part = path.substr(0, path.find('/'));
        const bool plain = !part.empty() && std::all_of(part.begin(), part.end(), is_plain);
        if (!plain || names_device(part)) return false;
        if (part.size() == path.size()) return true;
        path.remove_prefix(part.size() + 1);
    }
}

/// The folder around a package is easily named for it.
const fs::path& not_around_package(const fs::path& folder) {
    std::error_code status;
    // What cannot be looked into says so when it is opened.
    if (fs::exists(folder / kManifestName, status) || status) return folder;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, status)) {
        if (entry.path().extension() != ".lumi" || !entry.is_directory(status)) continue;
        throw Error(ErrorKind::kBadInput, "E-PACKAGE-MISSING",
                    folder.string() + ": is no package, but a folder that holds one",
                    "did you mean " + printable(entry.path().string()) + "?");
    }
    // A package that lost its manifest is still called one.
    if (fs::is_directory(folder, status) && folder.extension() != ".lumi") {
        throw Error(
            ErrorKind::kBadInput, "E-PACKAGE-MISSING",
            folder.string() + ": is no package: no " + std::string(kManifestName) + " lies in it",
            kNameThePackage);
    }
    return folder;
}

PackageFolder::PackageFolder(const fs::path& folder)
    : folder_(not_around_package(folder)),
      descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0) {
        const int error_number = errno;
        expect_access(folder, error_number);
        throw Error(
            ErrorKind::kBadInput, "E-PACKAGE-MISSING",
            folder.string() + ": expected the folder of a package: " + std::strerror(error_number),
            kNameThePackage);
    }
}

PackageFolder::~PackageFolder() { ::close(descriptor_); }

fs::path PackageFolder::path_of(const PackageFile& file) const { return folder_ / file.path; }

Bytes PackageFolder::read_unchecked(std::string_view path, std::uint64_t max_bytes) const {
    const fs::path shown = folder_ / path;
    const Descriptor file = open_below(descriptor_, path, shown);
    const std::uint64_t size = size_of_plain_file(file, shown);
    if (size > max_bytes) {
        refuse("E-PACKAGE-SIZE", shown,
               std::to_string(size) + " bytes, expected at most " + std::to_string(max_bytes));
    }
    return bytes_of(file, size, shown);
}

Bytes PackageFolder::read(const PackageFile& file) const {
    const fs::path shown = path_of(file);
    Bytes bytes = read_unchecked(file.path, file.bytes);
    if (bytes.size() != file.bytes) {
        refuse("E-PACKAGE-SIZE", shown,
               std::to_string(bytes.size()) + " bytes, expected " + std::to_string(file.bytes));
    }
    if (sha256_hex(bytes) != file.sha256) {
        refuse("E-PACKAGE-CHECKSUM", shown,
               "is not the file that was written: its SHA-256 differs");
    }
    return bytes;
}

}  // namespace lumi
