#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace lumi {

/// A folder that is written whole or not at all.
///
/// Files are written into `staging()`, a hidden sibling of the target; `put_in_place` then flushes
/// it and exchanges it with the target in one step, so that at every moment either the old folder
/// or the new one stands there whole. What a killed run left behind is cleaned up by the next
/// WholeFolder of the same target; folders of runs that are still alive are left alone.
///
/// One that is never put in place serves for what is needed on the way: nobody's files have its
/// name, and it goes with the object.
class WholeFolder {
 public:
    /// Missing parents are made. Throws Error (E-FILE-WRITE).
    explicit WholeFolder(const std::filesystem::path& target);
    /// Removes the staging folder, and with it the old one after an exchange.
    ~WholeFolder();
    WholeFolder(const WholeFolder&) = delete;
    WholeFolder& operator=(const WholeFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& staging() const { return staging_; }
    /// Takes into `staging()` what else lies in the target, whoever put it there: every file but
    /// those that `is_ours` knows by their names below the target ('/' between folders), and those
    /// that stand in `staging()` by now. To be called when all else is written. Throws Error
    /// (E-FILE-READ, E-FILE-WRITE): what cannot be kept is not to be lost.
    void keep_files_of_others(const std::function<bool(const std::string&)>& is_ours);
    /// Throws Error (E-FILE-WRITE) and leaves the old folder where it is.
    void put_in_place();

 private:
    void make_staging();

    std::filesystem::path target_;
    std::filesystem::path staging_;
    int lock_ = -1;  ///< The open staging folder, locked: this run is alive.
};

/// For before long work: throws what a WholeFolder of `target` would, as far as that can be told by
/// now, and makes nothing.
void require_writable_whole_folder(const std::filesystem::path& target);

/// Removes what killed runs left beside `target`; the next WholeFolder does so, too. Folders of
/// runs that are still alive are left alone.
void clean_up_after_killed_runs(const std::filesystem::path& target);

/// Throws Error (E-OUT-EXISTS): what stands at the path would be lost.
[[noreturn]] void refuse_loss(const std::filesystem::path& path, const std::string& reason);

/// For folders that a user names: what stands there is replaced as a whole, and a mistyped path
/// must not cost a folder of photographs. Throws Error (E-OUT-EXISTS) unless `folder` is missing,
/// or a folder that holds only files whose names `is_written_there` knows.
void expect_only_files_of_ours(const std::filesystem::path& folder,
                               const std::function<bool(const std::string&)>& is_written_there);

/// Exchange for file systems that have no atomic one: the old folder steps aside under a name from
/// which the next WholeFolder brings it back should the process die between the two renames.
/// Throws Error (E-FILE-WRITE).
void replace_folder_in_two_steps(const std::filesystem::path& fresh,
                                 const std::filesystem::path& target);

}  // namespace lumi
