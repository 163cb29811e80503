#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/work/progress.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "pipeline/evaluate/pictured_eye.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Photographs of a Lumigraph that were kept back (visit_kept_back), and the others, which they are
/// drawn from in different ways: uploaded once, when they are first asked, for all questions. Then
/// each round's others lie in memory, up to 70 views in all where a Lumigraph has 8 to 42; of more
/// views there is one round.
class KeptBackPhotographs {
 public:
    /// The arguments are those of visit_kept_back; Lumigraph, capture and progress must outlive it.
    KeptBackPhotographs(const Lumigraph& lumigraph, const Capture& capture,
                        const CameraMeshOptions& mesh_options, Progress& progress);
    ~KeptBackPhotographs();
    KeptBackPhotographs(const KeptBackPhotographs&) = delete;
    KeptBackPhotographs& operator=(const KeptBackPhotographs&) = delete;

    /// All of whose views they are some.
    [[nodiscard]] const Lumigraph& lumigraph() const { return lumigraph_; }
    /// How many photographs there are; 0 for fewer than eight views, of which nobody is asked.
    /// Throws Error (E-GL-...), as all below.
    [[nodiscard]] std::size_t count();
    /// Begins a question, which is what progress says from now on, where there is anyone to ask:
    /// as many as it returns.
    std::size_t ask(const std::string& question);
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
    std::optional<std::vector<Round>> rounds_;
};

}  // namespace lumi
