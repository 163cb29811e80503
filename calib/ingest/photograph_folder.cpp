#include "calib/ingest/photograph_folder.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <string_view>

#include "calib/ingest/made_by_lumi.h"
#include "calib/work/error.h"
#include "calib/work/printable.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 11> kReadExtensions{
    ".jpg", ".jpeg", ".jpe", ".jfif", ".png", ".tif", ".tiff", ".heic", ".heif", ".avif", ".webp"};
constexpr std::array<std::string_view, 8> kOtherPictureExtensions{".gif", ".bmp", ".exr", ".jxl",
                                                                  ".jp2", ".hdr", ".psd", ".ppm"};
// Most of these begin like a TIFF, and what a TIFF reader finds first in them is a thumbnail.
constexpr std::array<std::string_view, 23> kRawExtensions{
    ".nef", ".cr2", ".cr3", ".arw", ".dng", ".orf", ".rw2", ".raf", ".pef", ".srw", ".nrw", ".3fr",
    ".fff", ".iiq", ".gpr", ".rwl", ".erf", ".kdc", ".dcr", ".srf", ".sr2", ".mef", ".mos"};

template <std::size_t kCount>
bool is_one_of(const std::string& extension,
               const std::array<std::string_view, kCount>& extensions) {
    return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

std::string lower_extension(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& letter : extension) {
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
    return extension;
}

std::vector<std::uint8_t> first_bytes(const fs::path& path) {
    constexpr std::size_t kMagicBytes = 16;
    std::vector<std::uint8_t> bytes(kMagicBytes);
    std::ifstream stream(path, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), kMagicBytes);
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
    return bytes;
}

class FolderWalk {
 public:
    FolderWalk(const fs::path& root, const fs::path& working_folder,
               const std::vector<fs::path>& other_folders)
        : working_folder_(fs::weakly_canonical(working_folder)) {
        for (const fs::path& folder : other_folders) others_.insert(fs::weakly_canonical(folder));
        others_.erase(fs::weakly_canonical(root));
        walk(root, "");
        while (!links_.empty()) {
            const auto [prefix, folder] = *links_.begin();
            links_.erase(links_.begin());
            walk(folder, prefix);
        }
    }

    PhotographFolder take() {
        const auto by_name = [](const auto& a, const auto& b) { return a.name < b.name; };
        std::sort(found_.files.begin(), found_.files.end(), by_name);
        std::sort(found_.left_out.begin(), found_.left_out.end(), by_name);
        return std::move(found_);
    }

 private:
    void walk(const fs::path& folder, const std::string& prefix) {
        std::error_code status;
        const fs::path canonical = fs::weakly_canonical(folder, status);
        // Links may lead in a circle, or to a folder that lies here as well.
        if (!status && !walked_.insert(canonical).second) return;
        fs::directory_iterator entry;
        if (!status) entry = fs::directory_iterator(folder, status);
        for (; !status && entry != fs::directory_iterator(); entry.increment(status)) {
            const std::string file_name = entry->path().filename().string();
            if (file_name.starts_with('.')) continue;
            std::error_code ignored;
            if (entry->is_directory(ignored)) {
                enter(*entry, prefix, file_name);
            } else {
                classify(entry->path(), prefix + file_name);
            }
        }
        if (status) {
            leave_out(prefix.empty() ? "." : prefix, "E-INGEST-UNREADABLE",
                      "this folder cannot be read to its end: " + status.message());
        }
    }

    void enter(const fs::directory_entry& folder, const std::string& prefix,
               const std::string& file_name) {
        std::error_code ignored;
        const fs::path canonical = fs::weakly_canonical(folder.path(), ignored);
        if (!canonical.empty() && canonical == working_folder_) return;
        // Frames and workspaces come and go, and nobody looks for photographs there.
        if (is_made_by_lumi(folder.path())) return;
        if (others_.contains(canonical)) {
            leave_out(prefix + file_name, "E-INGEST-OWN",
                      "the configuration names it for something else: no photographs");
        } else if (folder.is_symlink(ignored)) {
            links_.emplace(prefix + file_name + "/", folder.path());
        } else {
            walk(folder.path(), prefix + file_name + "/");
        }
    }

    void classify(const fs::path& path, const std::string& name) {
        const std::string extension = lower_extension(path);
        const bool claims_to_be_read = is_one_of(extension, kReadExtensions);
        std::error_code ignored;
        if (!fs::is_regular_file(path, ignored)) {
            if (claims_to_be_read) {
                leave_out(name, "E-INGEST-UNREADABLE", "not a file, or a link that leads nowhere");
            }
            return;
        }
        if (is_one_of(extension, kRawExtensions)) {
            leave_out(name, "E-INGEST-FORMAT",
                      "a raw photograph: develop it into JPEG, PNG or TIFF");
            return;
        }
        const std::vector<std::uint8_t> bytes = first_bytes(path);
        const auto format = image_format_of(bytes);
        if (format && !is_utf8(name)) {
            leave_out(name, "E-INGEST-NAME", "its name is not UTF-8: rename the file");
        } else if (format) {
            found_.files.push_back({name, path, *format});
        } else if (claims_to_be_read) {
            leave_out(name, "E-INGEST-UNREADABLE",
                      bytes.empty()
                          ? "the file is empty or may not be read"
                          : "not a picture in a format that lumi reads, whatever its name says");
        } else if (is_one_of(extension, kOtherPictureExtensions)) {
            leave_out(name, "E-INGEST-FORMAT", "export it as JPEG, PNG or TIFF");
        }
    }

    /// Reports, which are UTF-8, name every file, whatever its name.
    void leave_out(const std::string& name, const std::string& code, const std::string& reason) {
        found_.left_out.push_back({printable(name), code, reason});
    }

    PhotographFolder found_;
    fs::path working_folder_;
    std::set<fs::path> others_;
    std::set<fs::path> walked_;
    std::map<std::string, fs::path> links_;  ///< To be walked when all that lies here has been.
};

}  // namespace

PhotographFolder list_photographs(const fs::path& folder, const fs::path& working_folder,
                                  const std::vector<fs::path>& other_folders) {
    std::error_code status;
    if (!fs::is_directory(folder, status)) {
        const bool is_file = fs::exists(folder, status);
        throw Error(ErrorKind::kBadInput, "E-INGEST-NOFOLDER",
                    folder.string() + (is_file ? ": is a file, expected a folder of photographs"
                                               : ": there is nothing at this path"),
                    "give the folder that holds the photographs");
    }
    return FolderWalk(folder, working_folder, other_folders).take();
}

}  // namespace lumi
