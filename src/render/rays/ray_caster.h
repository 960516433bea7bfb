// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/timer.h"
#include "field/bricks/detail.h"
#include "field/scene.h"
#include "gl/block_layout.h"
#include "gl/program.h"
#include "image/image.h"
#include "render/camera/camera.h"
#include "render/camera/placement.h"
#include "render/colours/classification.h"
#include "render/colours/mode.h"
#include "render/colours/segment_colours.h"
#include "render/marks/background.h"
#include "render/rays/occlusion.h"
#include "render/rays/square_lists.h"
#include "render/space/macrocells.h"
#include "render/space/slab_bounds.h"

#include <array>
#include <optional>
#include <vector>

namespace vs::render {

// The mode of a name. Throws UsageError listing the modes.
Mode modeFromName(const std::string& name);

// The view as shaders see it; mirrors ViewBlock in render/shaders/rays.glsl (std140).
struct ViewBlock {
    glm::vec4 viewForward{0}; // world, unit; w 1 if orthographic
    glm::vec4 viewRight{0};
    glm::vec4 viewUp{0};
    glm::vec4 eyeVoxel{0}; // voxel space, per step
    glm::vec4 forwardVoxel{0};
    glm::vec4 rightVoxel{0};
    glm::vec4 upVoxel{0};
    glm::vec4 viewport{1};
};
inline constexpr gl::BlockMember kViewBlockMembers[] = {
    VS_BLOCK_MEMBER(ViewBlock, viewForward),  VS_BLOCK_MEMBER(ViewBlock, viewRight),
    VS_BLOCK_MEMBER(ViewBlock, viewUp),       VS_BLOCK_MEMBER(ViewBlock, eyeVoxel),
    VS_BLOCK_MEMBER(ViewBlock, forwardVoxel), VS_BLOCK_MEMBER(ViewBlock, rightVoxel),
    VS_BLOCK_MEMBER(ViewBlock, upVoxel),      VS_BLOCK_MEMBER(ViewBlock, viewport)};
inline constexpr gl::BlockLayout kViewBlockLayout{"ViewBlock", sizeof(ViewBlock), kViewBlockMembers};
static_assert(isWhole(kViewBlockLayout));

ViewBlock viewBlock(const ViewRays& rays, const volume::GridGeometry& geometry);

// A part that was cut out, drawn again elsewhere (dual rendering: thesis, section 4.5).
struct PastedPart {
    Placement place;
    const gl::Texture* sculpture = nullptr;    // the part is where this is at least 0.5
    const Macrocells* macrocells = nullptr;    // made for it in probe view
    OcclusionVolume* occlusion = nullptr;      // where the frame has one
    const gl::Texture* segmentation = nullptr; // instead of the scene's
};

// A segment, drawn again elsewhere without having been cut out. It has no light of its own: it is lit
// plainly.
struct PulledSegment {
    Placement place;
    int label = 1; // in the scene's labels, or 1 where it has none
    bool isTranslucent = false;
    field::Scene scene;                     // with `segmentation`, and what is apart where others touch it
    const Macrocells* macrocells = nullptr; // where segments may be
};

// Everything one picture depends on. The pointers must stay alive until the picture is finished.
struct Frame {
    field::Scene scene;
    // Finer levels of the scene's data, which are drawn where the pixels ask for them; null: there are none,
    // or the picture is a draft. Where surfaces are those of smoothed values, the scene's own are drawn.
    field::Detail* detail = nullptr;
    const Macrocells* macrocells = nullptr;
    // Where segments may be, whatever else is there: overlay and volume mode look for their surfaces in these
    // cells only, most of which are empty, and segment mode in finer levels goes by the data alone elsewhere.
    // Null: wherever something may be.
    const Macrocells* segmentCells = nullptr;
    // Colours all modes, and says what is opaque in volume mode, which needs one. Null: ivory surfaces, white
    // rays.
    const Classification* classification = nullptr;
    std::vector<PastedPart> pasted;
    std::vector<PulledSegment> pulled;
    // Ambient occlusion and soft shadows; null: plain light.
    OcclusionVolume* occlusion = nullptr;
    ViewRays rays;
    Mode mode = Mode::Surface;
    // What is behind. A transparent picture has straight alpha: how much of the background each pixel hides.
    Background background = {};
    // MIP and X-ray: what is bright is black and what is dark is light, the studio's background too; colours
    // of transfer functions and segments, and other backgrounds, stay what they are.
    bool isInverted = false;
    double xrayGain = 5;           // brightness of a ray through one whole diagonal at full value
    SegmentColours segmentColours; // overlay and segment mode
    double sampleStep = 0.5;       // steps between samples in MIP, X-ray and volume; more for drafts
    int samples = 1;               // rays per pixel, evenly spread over it
    // Squares of pixels whose first two samples agree are left at that: most of a picture that is much
    // enlarged.
    bool endsEarly = false;
    // The pixels that are made, where the others are not asked for: their squares of 8 x 8 are cast, and no
    // other.
    std::optional<Box2> window;
};

// Casts rays (doc/behaviour.md, "Pictures") in a compute shader, some squares of pixels at a time so that no
// single submission is long. Start a frame, then render until it is complete; the picture can be looked at
// after every whole sample. Squares where nothing can be seen are only filled.
class RayCaster {
public:
    RayCaster();

    // Starts over with a new picture.
    void start(const Frame& frame);
    // Renders squares for about `budgetMs`, some at the least. True when all samples of the frame are done.
    // Where the frame has finer levels (Frame::detail) the one is used that its pixels ask for, and
    // rays that met missing bricks are cast again when those have been read, for which it waits within the
    // budget; then it returns after each whole sample, or mixed ones could be seen.
    bool renderSome(double budgetMs);
    // start() and everything at once.
    void render(const Frame& frame);

    [[nodiscard]] bool isComplete() const;
    // Samples per pixel that the picture holds everywhere so far.
    [[nodiscard]] int completedSamples() const { return isInGroups() ? kSettling : sample_; }
    // How much of the frame is done, 0 to 1.
    [[nodiscard]] double share() const;
    // The samples so far, averaged, as an RGBA8 texture of the frame's size; of its window alone, where it
    // has one.
    const gl::Texture& picture();
    // Downloaded: of the window's size where there is one.
    image::Image readPicture();
    // While rays of a picture of one part wait for bricks: how many squares of pixels do, 0 for none.
    [[nodiscard]] int squaresAwaited() const { return hasParts() ? 0 : awaited_; }
    // What there is of the first sample meanwhile: the pixels whose rays have all they need; the others are
    // transparent.
    image::Image readPixelsDone();

private:
    // What is drawn where: the pasted parts, the segments that are pulled out, and last what remains.
    struct Part {
        field::Scene scene;
        gl::Defines defines;              // of the variant of cast_rays.comp that draws it
        std::optional<glm::ivec2> pulled; // a segment that is pulled out: see field/shaders/scene.glsl
        const Macrocells* macrocells = nullptr;
        const Macrocells* segmentCells = nullptr; // null: the macrocells
        OcclusionVolume* occlusion = nullptr;
        ViewRays rays;
        float scale = 1;
        gl::Buffer view;
        gl::Texture beams;
        SlabBounds slabs;        // in MIP
        PartSquares squares;     // where there are several parts
        double squaresPerMs = 0; // of its last submission
    };
    // Whether the picture may show surfaces of translucent segments.
    static bool drawsTranslucent(const Frame& frame);
    // Whether the picture shows surfaces, and there are marks on them.
    static bool showsMarks(const Frame& frame);
    // The variant that draws what remains and pasted parts, and the one that draws a segment that is pulled
    // out.
    static field::Detail::Layers layersOf(const Frame& frame);
    static gl::Defines definesFor(const Frame& frame);
    static gl::Defines definesFor(const Frame& frame, const PulledSegment& segment);
    void arrangeParts();
    void become(Part& part, const PastedPart& pasted);
    void become(Part& part, const PulledSegment& segment);
    void place(Part& part, const Placement& placement);
    void bindPart(const Part& part);
    void bindPicture();
    void setPicture(gl::Program& program);
    static int beamShift(const Frame& frame);
    static int beamPixels(const Frame& frame);
    [[nodiscard]] Box2 window() const {
        return frame_.window.value_or(Box2{glm::ivec2(0), frame_.rays.size});
    }
    void findBeams();
    void listSquares();
    void listPartSquares();
    void boundSlabs();
    void resolve(gl::Program& program);
    [[nodiscard]] image::Image downloaded() const;
    [[nodiscard]] bool hasFilm() const;
    void fillFilm();

    // Where there are several parts, a sample has a stage for each of them, and one more which shows what
    // they show together; else it has one.
    [[nodiscard]] bool hasParts() const { return parts_.size() > 1; }
    [[nodiscard]] std::size_t stages() const { return hasParts() ? parts_.size() + 1 : 1; }
    [[nodiscard]] bool isLastStage() const { return stage_ + 1 == stages(); }
    [[nodiscard]] int squaresOfStage(std::size_t stage) const;
    void beginSample();
    void beginStage();
    void castSome(double milliseconds);
    void endStage();
    void setSample(gl::Program& program, int count) const;
    void castSquares(const Part& part, int count);
    void begin();
    void chooseLevel();
    void takeLevel();
    bool missesBricks(const Part& part, int count);
    bool haveBricksCome(double milliseconds);
    bool makeDo();
    void beginGroups();
    void endSampleOfGroup();
    [[nodiscard]] bool isInGroups() const { return groupEnd_ > 0; }
    [[nodiscard]] bool goesBackwards() const;
    [[nodiscard]] int endOfSquares() const { return isInGroups() ? groupEnd_ : squaresOfStage(stage_); }
    [[nodiscard]] double sampleStep() const;
    [[nodiscard]] int castRound() const;
    void clearSeen();
    void showSeen(int count);
    gl::Program& showParts(bool clears);

    std::vector<Part> parts_;
    gl::Texture seenFront_; // what the parts cast so far show; only where there are several
    gl::Texture seenBehind_;
    gl::Texture seenGlass_; // and where some segment is translucent
    gl::Texture seenGlassDepth_;
    gl::ProgramVariants castRays_{"render/shaders/cast_rays.comp"};
    gl::ProgramVariants resolve_{"render/shaders/resolve_picture.comp"};
    gl::ProgramVariants showParts_{"render/shaders/show_parts.comp"};
    gl::Program findBeams_;
    gl::Program fillFilm_;
    SquareLists squares_;
    gl::Buffer segmentColours_; // of the frame
    field::SceneBinding sceneBinding_;
    gl::Texture accumulation_;
    gl::Texture rounds_;       // of each pixel, which casting of it was the last without missing bricks
    std::optional<int> level_; // of the frame's detail, that its pixels ask for
    static constexpr int kAllSquares = 1 << 29; // more than there are
    int squaresAtOnce_ = kAllSquares;           // whose rays the pool has room for
    int awaited_ = 0;                           // squares that were just cast and wait for bricks; 0: none
    bool haveSomeCome_ = false;                 // since then
    Timer awaiting_;
    bool hasBegunSample_ = false;
    static constexpr int kSettling = 2; // samples, after which some squares may take no more
    int groupBegin_ = 0;                // squares that take all their other samples one after the other
    int groupEnd_ = 0;                  // 0: all squares take one sample after the other
    gl::Texture picture_;
    Frame frame_;
    int sample_ = 0;
    std::size_t stage_ = 0;        // of the current sample
    int square_ = 0;               // how many of its list this stage has
    double shownSquaresPerMs_ = 0; // of the last submission that showed what parts show
};

} // namespace vs::render
