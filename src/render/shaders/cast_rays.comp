// One sample per pixel of the picture: cast a ray, find what the mode asks for, colour it, add it to the
// accumulation. MODE: 0 surface, 1 MIP, 2 X-ray, 3 overlay (segmentation as surface, the rest as X-ray), 4
// segment (both as surface), 5 volume (compositing). SCULPTED: see surface.glsl. TF_KIND: what the transfer
// function goes by that colours all modes (classification.glsl); not defined: none does. SEGMENTS: in volume
// mode the surfaces of segments too, in MIP and X-ray their colours. TRANSLUCENT: overlay, segment and volume
// modes with translucent segments. LIT: with ambient occlusion and soft shadows. PARTS: several parts in one
// picture, one dispatch each; show_parts.comp shows them together. These are switches and no uniforms because
// each changes what is done at every sample of a ray or every hit, and a software renderer does both sides of
// a branch. PULLED: of the scene only one segment is seen, and in MIP and X-ray the data in it; APART: see
// scene.glsl. BRICKS: the data is that of a finer level, of which bricks may be missing: a ray that met such
// a place adds nothing, and is cast again when the brick has come. FINER: and its voxels are smaller than the
// scene's. MARKS: somebody has laid colours on the material (marks.glsl), FILLED: or added some (fill.glsl).
// BRICK_RANGES: rays go past what they need not look at by what bricks hold, not only by macrocells. PARTS
// alone stands outside of all loops: it is a switch because Mesa's software renderer compiles a program anew
// for other formats of the images that it names, and these would be whatever was bound before. In: the scene
// (field/shaders/scene.glsl), the view (rays.glsl). Out: image 0 (rgba32f) sum of display colours, and of
// coverage: how much of the background they hide.
// variants: MODE=0;MODE=0 SCULPTED=1;MODE=1;MODE=2 SCULPTED=1;MODE=3 SCULPTED=1;MODE=4;MODE=3 SCULPTED=1 TRANSLUCENT=1 PARTS=1;MODE=4 TRANSLUCENT=1 LIT=1;MODE=5 TF_KIND=0;MODE=5 SCULPTED=1 TF_KIND=2;MODE=0 TF_KIND=1;MODE=1 TF_KIND=0;MODE=2 TF_KIND=2;MODE=0 TRICUBIC=1;MODE=0 LIT=1;MODE=5 TF_KIND=0 LIT=1 PARTS=1;MODE=3 SCULPTED=1 PARTS=1;MODE=1 PARTS=1;MODE=0 QUADS=1;MODE=4 SCULPTED=1 QUADS=1 SMOOTHED=1;MODE=4 SCULPTED=1 CUT_ALONG_SEGMENTS=1;MODE=0 SCULPTED=1 TRICUBIC=1 SMOOTHED=1 TF_KIND=0;MODE=5 SCULPTED=1 TF_KIND=0 QUADS=1 TRICUBIC=1;MODE=5 SCULPTED=1 TF_KIND=0 SEGMENTS=1 TRANSLUCENT=1 PARTS=1;MODE=5 TF_KIND=2 SEGMENTS=1 LIT=1;MODE=1 SEGMENTS=1;MODE=1 TF_KIND=0 SEGMENTS=1;MODE=2 SCULPTED=1 SEGMENTS=1;MODE=2 TF_KIND=1 SEGMENTS=1;MODE=4 PULLED=1 PARTS=1;MODE=4 PULLED=1 APART=1 SCULPTED=1 PARTS=1;MODE=3 PULLED=1 APART=1 TRANSLUCENT=1 PARTS=1;MODE=1 PULLED=1 APART=1 PARTS=1;MODE=2 PULLED=1 PARTS=1;MODE=5 TF_KIND=2 SEGMENTS=1 PULLED=1 APART=1 PARTS=1;MODE=0 BRICKS=1 BRICK_RANGES=1;MODE=1 BRICKS=1;MODE=2 BRICKS=1 BRICK_RANGES=1 SCULPTED=1;MODE=5 TF_KIND=0 BRICKS=1 BRICK_RANGES=1 TRICUBIC=1;MODE=5 TF_KIND=2 BRICKS=1 BRICK_RANGES=1 FINER=1 LIT=1;MODE=4 BRICKS=1 SCULPTED=1 TRANSLUCENT=1 PARTS=1;MODE=0 BRICKS=1 FINER=1 SCULPTED=1 FINER_CUTS=1;MODE=5 TF_KIND=0 BRICKS=1 FINER=1 SCULPTED=1 FINER_CUTS=1;MODE=4 BRICKS=1 BRICK_RANGES=1 FINER=1 FINER_SEGMENTS=1;MODE=3 BRICKS=1 BRICK_RANGES=1 FINER=1 SCULPTED=1 TRANSLUCENT=1 FINER_CUTS=1 FINER_SEGMENTS=2;MODE=5 TF_KIND=2 SEGMENTS=1 BRICKS=1 FINER=1 FINER_SEGMENTS=1;MODE=2 SEGMENTS=1 BRICKS=1 BRICK_RANGES=1 FINER=1 FINER_SEGMENTS=2;MODE=4 PULLED=1 PARTS=1 BRICKS=1 FINER_SEGMENTS=1 ALL_SEGMENTS=1;MODE=0 MARKS=1;MODE=4 SCULPTED=1 TRANSLUCENT=1 LIT=1 MARKS=1;MODE=3 PULLED=1 APART=1 TRANSLUCENT=1 PARTS=1 MARKS=1;MODE=5 SCULPTED=1 TF_KIND=2 SEGMENTS=1 TRANSLUCENT=1 LIT=1 PARTS=1 MARKS=1 BRICKS=1 BRICK_RANGES=1 FINER=1 FINER_CUTS=1 FINER_SEGMENTS=2;MODE=3 BRICKS=1 BRICK_RANGES=1 FINER=1 SCULPTED=1 TRANSLUCENT=1 FINER_CUTS=1 FINER_SEGMENTS=2 MARKS=1 PARTS=1;MODE=0 FILLED=1;MODE=0 SCULPTED=1 FILLED=2 MARKS=1;MODE=1 FILLED=1;MODE=1 TF_KIND=0 SEGMENTS=1 FILLED=2;MODE=2 SCULPTED=1 FILLED=1;MODE=3 SCULPTED=1 TRANSLUCENT=1 FILLED=2 PARTS=1;MODE=4 SCULPTED=1 TRANSLUCENT=1 LIT=1 FILLED=2;MODE=0 SCULPTED=1 TRICUBIC=1 SMOOTHED=1 TF_KIND=1 FILLED=1;MODE=5 SCULPTED=1 TF_KIND=0 FILLED=1 QUADS=1;MODE=5 SCULPTED=1 TF_KIND=2 SEGMENTS=1 TRANSLUCENT=1 LIT=1 PARTS=1 MARKS=1 FILLED=2 BRICKS=1 BRICK_RANGES=1 FINER=1 FINER_CUTS=1 FINER_SEGMENTS=2
layout(local_size_x = 64) in;

// What surfaces are looked for (surface.glsl), and where (rays.glsl): those of segments alone in cells of
// their own.
#if MODE == 4 && !defined(PULLED)
#define CONTENT 2
#ifdef BRICK_RANGES
#define DATA_BESIDE_SEGMENTS
#endif
#elif MODE == 4
#define CONTENT 1
#elif MODE == 3 || (MODE == 5 && defined(SEGMENTS))
#define CONTENT 1
#define SEGMENT_CELLS
#else
#define CONTENT 0
#define DATA_ONLY
#ifdef PULLED
#define WITHIN_SEGMENTS
#endif
#endif

#if MODE == 5
#define DATA_BY_FUNCTION
#endif

// 8, of a voxel. Loops over a number that the compiler does not know stay loops, which a software renderer
// leaves after one turn where nothing was met.
uniform int corners;

#include "field/shaders/bindings.glsl"
#include "render/shaders/bindings.glsl"
#include "field/shaders/scene.glsl"
#include "render/shaders/rays.glsl"
#include "render/shaders/squares.glsl"
#include "render/shaders/surface.glsl"
#if MODE == 1
#define SLABS
#include "render/shaders/slabs.glsl"
#endif
#include "render/shaders/maximum.glsl"
#include "render/shaders/shading.glsl"
#ifdef TF_KIND
#include "render/shaders/classification.glsl"
#include "render/shaders/gradients.glsl"
#endif
#ifdef LIT
#include "render/shaders/occlusion.glsl"
#endif
#ifdef MARKS
#include "field/shaders/marks.glsl"
#endif
#if MODE == 5
#include "render/shaders/composite.glsl"
#endif

layout(binding = kBeamsTexture)
    uniform sampler2D beams; // where along its rays each square of pixels may show something

uniform vec2 exposure;      // x: X-ray gain per diagonal; y: volume's diagonal in steps
uniform float sampleStep;   // steps between samples in MIP and volume mode
uniform int beamShift;      // side of a beam's square: 1 << this; division is slow
uniform vec4 backgroundTop; // display colour; w 1: there is none, and it is black
uniform vec4 backgroundBottom;
#if MODE == 1 || MODE == 2
// The picture is complemented when it is done: white rays become black, and colours that are to stay are
// accumulated as their complements.
uniform int isInverted;
#endif
#if MODE == 2 || MODE == 3
uniform vec2 lattice; // of samples in an X-ray: x steps between them, y what part of that they are shifted by
#endif
#ifdef BRICKS
// Of each pixel the last round, counted over samples and parts, in which its ray met no missing brick.
layout(r32ui, binding = kRoundsImage) uniform uimage2D rounds;
uniform int castRound;
#endif
#ifdef PARTS
uniform float partScale; // how large it is drawn
#else
const float partScale = 1.0;
#endif

#if MODE == 3 || MODE == 4 || defined(SEGMENTS)
#include "render/shaders/segments.glsl"
#endif
#ifdef TRANSLUCENT
#include "render/shaders/glass.glsl"
#endif
#include "render/shaders/seen.glsl"
#include "render/shaders/seen_along.glsl"
#ifdef PARTS
#include "render/shaders/parts.glsl"
#endif

// Different for each pixel and sample, the same each time (interleaved gradient noise, Jimenez 2014).
float startJitter(ivec2 pixel) {
    return fract(52.9829189 * fract(dot(vec2(pixel) + 64.0 * pixelOffset, vec2(0.06711056, 0.00583715))));
}

void main() {
    ivec2 pixel = pixelOfInvocation();
    if (any(greaterThanEqual(pixel, ivec2(viewport.xy)))) {
        return;
    }
#ifdef BRICKS
    if (imageLoad(rounds, pixel).r >= uint(castRound)) {
        return;
    }
#endif
    vec2 position = vec2(pixel) + pixelOffset;
    Ray ray = rayThrough(position);
    ray.beam = pixel >> beamShift;
    ray.beamEnds = texelFetch(beams, ray.beam, 0).rg;
    ray.tBegin = max(ray.tBegin, ray.beamEnds.x);
    ray.tEnd = min(ray.tEnd, ray.beamEnds.y);
    Seen seen = seenAlong(ray, startJitter(pixel), partScale);
#ifdef BRICKS
    if (isBrickMissing) {
        return;
    }
    imageStore(rounds, pixel, uvec4(castRound));
#endif
#ifdef PARTS
    addToParts(pixel, seen);
#else
    vec3 behind = background(position, viewport.xy, backgroundTop.xyz, backgroundBottom.xyz);
#if MODE == 1 || MODE == 2 || MODE == 3
    behind = behindFilm(behind, ray.tNear < ray.tFar);
#endif
    addToPicture(pixel, shown(seen, behind));
#endif
}
