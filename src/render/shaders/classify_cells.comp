// Marks the macrocells that may hold something visible, one bit each: the first of the planes of
// cell_bits.glsl. One invocation a row of 32 cells along x. In: textures 0 data ranges; with VS_SCULPTURE 1
// sculpture ranges; with VS_SEGMENTATION 2 segmentation ranges (rg: smallest, largest value in the cell);
// with VS_FINER_SEGMENTS surfaces are those of a finer level, which lie where the scene's segments are not
// far; with VS_FILLED 6 cells that may hold material. With VS_DATA the data is drawn; with VS_BY_FUNCTION the
// transfer function says what of it can be seen, not the displayed range, with VS_GRADIENTS also by the
// gradient magnitudes in the cell (texture 8 gradient ranges). In and out: storage 0 planes. Out: storage 1,
// 1 where the first plane was another.
// variants: VS_DATA=1;VS_DATA=1 VS_BY_FUNCTION=1;VS_DATA=1 VS_BY_FUNCTION=1 VS_GRADIENTS=1 VS_SCULPTURE=1;VS_DATA=1 VS_SEGMENTATION=1 VS_FINER_SEGMENTS=1;VS_DATA=1 VS_SCULPTURE=1 VS_FILLED=1;VS_DATA=1 VS_BY_FUNCTION=1 VS_GRADIENTS=1 VS_SCULPTURE=1 VS_FILLED=1
layout(local_size_x = 4, local_size_y = 16) in;

#include "gl/shaders/place.glsl"

#include "render/shaders/bindings.glsl"
layout(binding = kDataCellsTexture) uniform sampler3D dataCells;
layout(binding = kSculptureCellsTexture) uniform sampler3D sculptureCells;
layout(binding = kSegmentationCellsTexture) uniform sampler3D segmentationCells;
#ifdef VS_FILLED
layout(binding = kFilledCellsTexture) uniform sampler3D filledCells;
#endif

uniform ivec3 firstRow; // the cells that are looked at, from here, x a multiple of 32,
uniform ivec3 endRow;   // and before that place
uniform vec2 displayedRange;
uniform int isProbe; // 1: what was cut away is seen, else what is left

#include "render/shaders/cell_bits.glsl"
layout(std430, binding = kPlanesStorage) buffer Planes { uint planes[]; };
layout(std430, binding = kOtherPlaneStorage) writeonly buffer OtherPlane { uint isOther; };

#ifdef VS_BY_FUNCTION
#define TF_KIND 0
#include "render/shaders/classification.glsl"
#ifdef VS_GRADIENTS
layout(binding = kGradientCellsTexture) uniform sampler3D gradientCells;
#endif
#endif

bool mayHoldSomething(ivec3 cell) {
    bool mayHold = false;
#ifdef VS_DATA
    vec2 data = texelFetch(dataCells, cell, 0).rg;
#ifdef VS_GRADIENTS
    float steepest = texelFetch(gradientCells, cell, 0).g * lightingOfFunction.w;
    mayHold = mayBeVisible(data.x, data.y, steepest);
#elif defined(VS_BY_FUNCTION)
    mayHold = mayBeVisible(data.x, data.y);
#else
    mayHold = data.y >= displayedRange.x && data.x <= displayedRange.y;
#endif
#endif
#ifdef VS_SEGMENTATION
    float most = texelFetch(segmentationCells, cell, 0).g;
#ifdef VS_FINER_SEGMENTS
    mayHold = mayHold || most > 0.0;
#else
    mayHold = mayHold || most >= 0.5;
#endif
#endif
#ifdef VS_SCULPTURE
    vec2 sculpture = texelFetch(sculptureCells, min(cell, textureSize(sculptureCells, 0) - 1), 0).rg;
    mayHold = mayHold && (isProbe != 0 ? sculpture.g >= 0.5 : sculpture.r < 0.5);
#endif
#ifdef VS_FILLED
    mayHold = mayHold || texelFetch(filledCells, cell, 0).r > 0.0;
#endif
    return mayHold;
}

void main() {
    ivec3 row = firstRow + placeOfInvocation() * ivec3(kBlock.x, 1, 1);
    if (any(greaterThanEqual(row, endRow))) {
        return;
    }
    uint bits = 0u;
    for (int x = 0; x < kBlock.x; ++x) {
        ivec3 cell = row + ivec3(x, 0, 0);
        bits |= uint(mayHoldSomething(min(cell, cells - 1)) && cell.x < cells.x) << x;
    }
    int place = blockAt(row / kBlock) * kBlock.y + row.y % kBlock.y;
    if (planes[place] != bits) {
        isOther = 1u; // whichever invocation says so
        planes[place] = bits;
    }
}
