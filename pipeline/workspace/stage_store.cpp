#include "pipeline/workspace/stage_store.h"

#include "calib/work/whole_folder.h"
#include "pipeline/workspace/stage_outputs.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// The same files in two places. File systems without hard links get copies.
void link_tree(const fs::path& from, const fs::path& to) {
    for (const auto& entry : fs::recursive_directory_iterator(from)) {
        const fs::path target = to / entry.path().lexically_relative(from);
        if (entry.is_directory()) {
            fs::create_directories(target);
            continue;
        }
        fs::create_directories(target.parent_path());
        std::error_code failure;
        fs::create_hard_link(entry.path(), target, failure);
        if (failure) fs::copy_file(entry.path(), target);
    }
}

}  // namespace

fs::path StageStore::place_of(const StageIdentity& identity) const {
    return folder_ / (identity.stage + '-' + stage_key(identity));
}

std::optional<DoneMarker> StageStore::fetch(const StageIdentity& identity,
                                            const Workspace& workspace, int threads) const {
    const fs::path kept = place_of(identity);
    std::optional<DoneMarker> marker = read_done_marker(kept / kDoneMarkerName);
    if (!marker || stage_key(marker->identity) != stage_key(identity)) return std::nullopt;
    WholeFolder folder(workspace.stage_folder(identity.stage));
    link_tree(kept, folder.staging());
    if (!are_unharmed(folder.staging(), identity.stage, marker->outputs, threads)) {
        return std::nullopt;
    }
    folder.put_in_place();
    return marker;
}

void StageStore::keep(const StageIdentity& identity, const Workspace& workspace) const {
    WholeFolder folder(place_of(identity));
    link_tree(workspace.stage_folder(identity.stage), folder.staging());
    folder.put_in_place();
}

void StageStore::keep_failure(const StageIdentity& identity, const Error& failure) {
    if (failure.kind() == ErrorKind::kDegenerateCapture)
        failures_.emplace(stage_key(identity), failure);
}

std::optional<Error> StageStore::failure_of(const StageIdentity& identity) const {
    const auto failure = failures_.find(stage_key(identity));
    return failure == failures_.end() ? std::nullopt : std::optional(failure->second);
}

}  // namespace lumi
