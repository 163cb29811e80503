#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "calib/poses/mapping_job.h"
#include "tests/calib/mapping/matched_scene.h"

namespace lumi {

/// A capture after matching, as what maps it is given it.
class MatchedJob : public testing::Test {
 protected:
    void match(Capture truth) {
        scene_ = matched_scene(std::move(truth));
        matched_.photographs = scene_.photographs;
        matched_.pairs = scene_.pairs;
        groups_.cameras = scene_.cameras;
        for (const std::string& name : names_of(scene_.truth)) {
            photographs_.emplace_back();
            photographs_.back().name = name;
            groups_.camera_of_photograph.push_back(0);
        }
    }

    [[nodiscard]] MappingJob job() {
        return {photographs_, groups_, options_, true, false, "", 1, progress_, evidence_};
    }

    MatchedScene scene_;
    MatchedPhotographs matched_;
    std::vector<Photograph> photographs_;
    CameraGroups groups_;
    PoseOptions options_;
    PoseEvidence evidence_;
    SilentProgress progress_;
};

}  // namespace lumi
