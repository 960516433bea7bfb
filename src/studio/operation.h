// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "field/scene.h"
#include "render/background.h"
#include "render/ray_caster.h"
#include "render/transfer_function.h"
#include "sculpt/stroke.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vs::studio {

// How the document is looked at. Not an edit, but edits are drawn on a view, so sessions keep it.
struct View {
    render::Camera camera;
    render::Mode mode = render::Mode::Surface;
    Range range; // displayed range, in the volume's unit
    field::SculptureView sculptureView = field::SculptureView::Cut;
    // Colours every mode; nothing: ivory surfaces and white rays, and in volume mode one made from the
    // displayed range.
    std::optional<render::TransferFunction> transferFunction = {};
    // Where copies of what was cut out are drawn too. They can be looked at; pens go through them.
    std::vector<render::Placement> pasted = {};
    field::Sampling sampling = field::Sampling::Trilinear;

    bool operator==(const View&) const = default;
};

enum class Shape { FreeForm, Ellipse, Circle, Rectangle, Polyline };

// What the pen drew, in viewport pixels (y down): for FreeForm and Polyline the points themselves, for
// Ellipse, Circle and Rectangle two opposite corners of the box around it (for Circle the first point is the
// centre, the second on the rim).
struct Sketch {
    Shape shape = Shape::FreeForm;
    std::vector<glm::dvec2> points;

    bool operator==(const Sketch&) const = default;
};

// On what an edit was drawn.
struct Canvas {
    View view;
    glm::ivec2 viewport{1230, 870}; // pixels

    bool operator==(const Canvas&) const = default;
};

// The operations: one document change each, as values. The window, the command line and a replayed session
// all make these, and nothing else changes a document. A canvas that is not set means the document's view at
// that moment, on a viewport of 1230 x 870.

// Looks from elsewhere, at another range, in another mode. What is not set stays.
struct SetView {
    std::optional<render::Camera> camera;
    std::optional<render::Mode> mode;
    std::optional<Range> range;
    std::optional<field::SculptureView> sculptureView;
    std::optional<std::optional<render::TransferFunction>> transferFunction =
        {}; // set to nothing: without one
    std::optional<std::vector<render::Placement>> pasted = {};
    std::optional<field::Sampling> sampling = {};
};
// The whole of a view.
SetView lookAs(const View& view);

// Peels layers (steps, fractions count) off the surface under the sketch, each element along its own normal.
struct Peel {
    Sketch mask;
    double layers = 0;
    int radius = 3; // voxels: the radiation's R
    std::optional<Canvas> canvas;
};

// Drills along the view through the sketch's shape, carried along by the pen: each pen point stamps the mask,
// centred on it, as deep as depthMax * pressure (steps). Without pen points, one stamp where the mask was
// drawn, at full pressure.
struct Drill {
    Sketch mask;
    sculpt::Stroke stroke;
    double depthMax = 10;
    int radius = 3;
    std::optional<Canvas> canvas;
};

// Puts seeds on the surface under the strokes: free-form and polyline sketches are open lines of the given
// width, the others are filled. The run takes the displayed range as its intensity range when `range` is not
// set. `voxels` holds what was found; when it is not empty on replay, those are used instead of casting rays
// again.
struct Seed {
    std::vector<Sketch> strokes;
    double widthPixels = 5;
    std::optional<Range> range;
    int connectivity = 6;
    std::vector<glm::ivec3> voxels;
    std::optional<Canvas> canvas;
};

// Lets the region grow: so many generations, or until nothing grows any more. The sculpture fences it as
// `sculptureView` says: the view's when not set.
struct Grow {
    std::optional<int> generations = {};
    std::optional<field::SculptureView> sculptureView = {};
};

// Plays backward by so many generations.
struct Rewind {
    int generations = 1;
};

// Changes the running growth's intensity range, in the volume's unit.
struct SetGrowthRange {
    Range range;
};

struct Undo {};
struct Redo {};
struct UnCut {};  // clears all cuts
struct ReSeed {}; // clears the segmentation

// Writes the view as a PNG into the output folder, with a scale bar and an orientation marker if asked for.
// Does not change the document.
struct SavePicture {
    std::string file;
    glm::ivec2 size{1230, 870};
    int samples = 8;
    render::Background background = {};
    bool annotations = false;
};

// Writes the grown region as a label map (uint8, 1 = inside) into the output folder.
struct SaveLabels {
    std::string file;
};

// Writes the sculpture volume (float, 0 untouched .. 1 cut away) into the output folder.
struct SaveSculpture {
    std::string file;
};

using Operation = std::variant<SetView, Peel, Drill, Seed, Grow, Rewind, SetGrowthRange, Undo, Redo, UnCut,
                               ReSeed, SavePicture, SaveLabels, SaveSculpture>;

// "view", "peel", "drill", "seed", "grow", "rewind", "growth range", "undo", "redo", "un-cut", "re-seed",
// "picture", "labels", "sculpture": the names in sessions, reports and the history.
const char* name(const Operation& operation);

// Whether an operation only writes a file and leaves the document as it is.
bool isOutput(const Operation& operation);

} // namespace vs::studio
