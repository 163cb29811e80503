#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "calib/work/error.h"
#include "pipeline/workspace/done_marker.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// Finished stages by what decides their result, so that workspaces which are variants of one
/// another share what they have in common. Files are shared by hard links: no stage changes a
/// finished file, it puts another in its place.
class StageStore {
 public:
    /// Folders are made when something is kept.
    explicit StageStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Puts a kept result into the workspace and returns its marker; empty when none with this
    /// identity is kept, or when its files were harmed.
    [[nodiscard]] std::optional<DoneMarker> fetch(const StageIdentity& identity,
                                                  const Workspace& workspace, int threads) const;

    /// Keeps a stage that is finished in the workspace. Throws Error (E-FILE-WRITE).
    void keep(const StageIdentity& identity, const Workspace& workspace) const;

    /// Keeps what ended a stage, as long as this object lives, where it is that photographs cannot
    /// tell what was asked of them: the same would end it again, after as long a time.
    void keep_failure(const StageIdentity& identity, const Error& failure);
    /// Empty when none is kept.
    [[nodiscard]] std::optional<Error> failure_of(const StageIdentity& identity) const;

 private:
    [[nodiscard]] std::filesystem::path place_of(const StageIdentity& identity) const;

    std::filesystem::path folder_;
    std::map<std::string, Error> failures_;  ///< By what decides the result.
};

}  // namespace lumi
