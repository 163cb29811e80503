#include "calib/work/whole_folder.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "calib/work/unfinished_sibling.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// The target without a trailing slash and with links resolved, so that its sibling is on the same
/// file system.
fs::path settled(const fs::path& target) {
    fs::path path = fs::weakly_canonical(fs::absolute(target).lexically_normal());
    if (!path.has_filename()) path = path.parent_path();
    return path;
}

fs::path aside(const fs::path& target) {
    return target.parent_path() / ("." + target.filename().string() + ".old");
}

int open_folder(const fs::path& path) {
    return ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

bool is_still_there(const fs::path& path, int descriptor) {
    struct stat opened {};
    struct stat named {};
    return ::fstat(descriptor, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

/// A staging folder that nobody holds belonged to a run that died.
void remove_if_abandoned(const fs::path& staging) {
    const int descriptor = open_folder(staging);
    if (descriptor < 0) return;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
        std::error_code ignored;
        fs::remove_all(staging, ignored);
    }
    ::close(descriptor);
}

bool cannot_exchange(int error_number) {
    return error_number == EINVAL || error_number == ENOSYS || error_number == EOPNOTSUPP;
}

void move_into_place(const fs::path& fresh, const fs::path& target) {
    std::error_code ignored;
    if (fs::exists(target, ignored)) return replace_folder_in_two_steps(fresh, target);
    if (::rename(fresh.c_str(), target.c_str()) != 0) refuse_write(target, errno);
}

/// Every file below a folder, by its name there. Throws Error (E-FILE-READ).
std::vector<fs::path> names_below(const fs::path& folder) {
    std::vector<fs::path> names;
    std::error_code status;
    fs::recursive_directory_iterator entry(folder, status);
    for (; !status && entry != fs::recursive_directory_iterator(); entry.increment(status)) {
        if (entry->symlink_status().type() != fs::file_type::directory)
            names.push_back(entry->path().lexically_relative(folder));
    }
    if (status) {
        throw Error(ErrorKind::kBadInput, "E-FILE-READ", folder.string() + ": " + status.message(),
                    "check that you may read the folder and those in it");
    }
    return names;
}

/// One file in two places; a copy where the file system knows no links.
void link_or_copy(const fs::path& from, const fs::path& to) {
    std::error_code status;
    fs::create_directories(to.parent_path(), status);
    if (status) refuse_write(to, status.value());
    fs::create_hard_link(from, to, status);
    if (status && status != std::errc::file_exists)
        fs::copy(from, to, fs::copy_options::copy_symlinks, status);
    if (status) refuse_write(to, status.value());
}

}  // namespace

void require_writable_whole_folder(const fs::path& target) {
    require_writable_folder(settled(target).parent_path());
}

void clean_up_after_killed_runs(const fs::path& unsettled_target) {
    const fs::path target = settled(unsettled_target);
    std::error_code ignored;
    if (fs::exists(aside(target), ignored)) {
        if (!fs::exists(target, ignored)) fs::rename(aside(target), target, ignored);
        // Where it could not come back it is the only one.
        if (fs::exists(target, ignored)) fs::remove_all(aside(target), ignored);
    }
    const std::string prefix = unfinished_prefix(target);
    for (const fs::directory_entry& entry : fs::directory_iterator(target.parent_path(), ignored)) {
        if (entry.path().filename().string().starts_with(prefix)) remove_if_abandoned(entry.path());
    }
}

void refuse_loss(const fs::path& path, const std::string& reason) {
    throw Error(ErrorKind::kUsage, "E-OUT-EXISTS", printable(path.string()) + ": " + reason,
                "name a folder that is new or empty, or remove what is there first");
}

void expect_only_files_of_ours(const fs::path& folder,
                               const std::function<bool(const std::string&)>& is_written_there) {
    std::error_code status;
    if (!fs::exists(fs::symlink_status(folder, status))) return;
    if (!fs::is_directory(folder, status))
        refuse_loss(folder, "is there already and is not a folder");
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const bool is_file = entry.symlink_status().type() == fs::file_type::regular;
        if (!is_file || !is_written_there(entry.path().filename().string()))
            refuse_loss(entry.path(), "would be lost, as the folder is written anew");
    }
}

void replace_folder_in_two_steps(const fs::path& fresh, const fs::path& target) {
    const fs::path old = aside(target);
    if (::rename(target.c_str(), old.c_str()) != 0) refuse_write(target, errno);
    if (::rename(fresh.c_str(), target.c_str()) != 0) {
        const int reason = errno;
        if (::rename(old.c_str(), target.c_str()) != 0) refuse_write(old, errno);
        refuse_write(target, reason);
    }
    std::error_code ignored;
    fs::remove_all(old, ignored);
}

WholeFolder::WholeFolder(const fs::path& target) : target_(settled(target)) {
    std::error_code status;
    fs::create_directories(target_.parent_path(), status);
    if (status) refuse_write(target_, status.value());
    clean_up_after_killed_runs(target_);
    make_staging();
}

void WholeFolder::make_staging() {
    // Another run may take a folder that is not locked yet for an abandoned one: then try again.
    while (lock_ < 0) {
        staging_ =
            make_unfinished_sibling(target_, [](const char* path) { return ::mkdir(path, 0777); });
        const int descriptor = open_folder(staging_);
        if (descriptor < 0 && errno != ENOENT) refuse_write(staging_, errno);
        if (descriptor < 0) continue;
        ::flock(descriptor, LOCK_EX);  // Not every file system can; then nothing is cleaned either.
        if (is_still_there(staging_, descriptor)) {
            lock_ = descriptor;
        } else {
            ::close(descriptor);
        }
    }
}

WholeFolder::~WholeFolder() {
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
    ::close(lock_);
}

void WholeFolder::keep_files_of_others(const std::function<bool(const std::string&)>& is_ours) {
    std::error_code status;
    if (!fs::is_directory(target_, status)) return;
    for (const fs::path& name : names_below(target_)) {
        const fs::path kept = staging_ / name;
        const fs::file_type made = fs::symlink_status(kept, status).type();
        const bool is_replaced =
            made != fs::file_type::not_found && made != fs::file_type::directory;
        if (!is_replaced && !is_ours(name.generic_string())) link_or_copy(target_ / name, kept);
    }
}

void WholeFolder::put_in_place() {
    flush_folder(staging_);
    if (::renameat2(AT_FDCWD, staging_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) != 0) {
        const int reason = errno;
        // ENOENT: there is no old folder to exchange with.
        if (reason != ENOENT && !cannot_exchange(reason)) refuse_write(target_, reason);
        move_into_place(staging_, target_);
    }
    flush_folder(target_.parent_path());
}

}  // namespace lumi
