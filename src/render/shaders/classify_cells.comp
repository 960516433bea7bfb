// Marks the macrocells that may hold something visible.
// In: textures 0 data ranges, 1 sculpture ranges, 2 segmentation ranges (rg: smallest, largest value in the cell).
// Out: image 0 (r32ui): 0 may hold something, `far` holds nothing.
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;

layout(binding = 0) uniform sampler3D dataCells;
layout(binding = 1) uniform sampler3D sculptureCells;
layout(binding = 2) uniform sampler3D segmentationCells;
layout(r32ui, binding = 0) uniform writeonly uimage3D distances;

layout(location = 0) uniform vec2 displayedRange;
layout(location = 1) uniform int view;  // 0 whole, 1 cut, 2 probe
layout(location = 2) uniform int draws; // bit 0 data, bit 1 segmentation
layout(location = 3) uniform int far;
layout(location = 4) uniform int byFunction; // 1: the transfer function says what can be seen, not the displayed range

#define TF_KIND 0
#include "render/shaders/classification.glsl"

void main() {
    ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(cell, imageSize(distances)))) {
        return;
    }
    vec2 data = texelFetch(dataCells, cell, 0).rg;
    vec2 segmentation = texelFetch(segmentationCells, (draws & 2) != 0 ? cell : ivec3(0), 0).rg;
    vec2 sculpture = texelFetch(sculptureCells, min(cell, textureSize(sculptureCells, 0) - 1), 0).rg;
    bool isVisible = byFunction != 0 ? mayBeVisible(data.x, data.y)
                                     : data.y >= displayedRange.x && data.x <= displayedRange.y;
    bool hasContent = ((draws & 1) != 0 && isVisible) ||
                      ((draws & 2) != 0 && segmentation.y >= 0.5);
    bool isOnVisibleSide = view == 0 || (view == 1 ? sculpture.x < 0.5 : sculpture.y >= 0.5);
    imageStore(distances, cell, uvec4(hasContent && isOnVisibleSide ? 0u : uint(far)));
}
