#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/work/progress.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "pipeline/evaluate/pictured_eye.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Photographs of a Lumigraph that were kept back (visit_kept_back), and the others, which they are
/// drawn from in different ways: uploaded once, when the first is drawn, for all that is asked of
/// them.
class KeptBackPhotographs {
 public:
    /// The arguments are those of visit_kept_back; Lumigraph, capture and progress must outlive it.
    KeptBackPhotographs(const Lumigraph& lumigraph, const Capture& capture,
                        const CameraMeshOptions& mesh_options, Progress& progress);
    ~KeptBackPhotographs();
    KeptBackPhotographs(const KeptBackPhotographs&) = delete;
    KeptBackPhotographs& operator=(const KeptBackPhotographs&) = delete;

    /// Begins a question; progress says what it is.
    void ask(const std::string& question);

    /// How many photographs there are; 0 for fewer than eight views, of which nobody is asked.
    /// Throws Error (E-GL-...), as all below.
    [[nodiscard]] std::size_t count();
    /// Each of them, and what draws the others as these choices say. Throws what `visit` throws.
    void visit(
        const DrawingChoices& drawing,
        const std::function<void(OffscreenRenderer& others, const PicturedEye& kept_back)>& visit);
    /// All of them, drawn from the others as these say.
    [[nodiscard]] DrawnPictures draw(const DrawingChoices& drawing, const RenderOptions& options);

 private:
    struct Round;
    std::vector<Round>& rounds();

    const Lumigraph& lumigraph_;
    const Capture& capture_;
    CameraMeshOptions mesh_options_;
    Progress& progress_;
    bool is_kept_back_ = false;
    std::vector<Round> rounds_;
};

}  // namespace lumi
