#pragma once

#include <filesystem>
#include <optional>

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

 private:
    [[nodiscard]] std::filesystem::path place_of(const StageIdentity& identity) const;

    std::filesystem::path folder_;
};

}  // namespace lumi
