// Which segments that are shown have voxels in a tile or so close to it that smoothing carries them into it:
// 256 bits a tile, one for each label. One group a tile. In: storage 0 tiles, 3 and 4 voxels shown; texture 3
// labels. Out: storage 5.
#include "segment/shaders/tiles.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
layout(binding = kLabelTexture) uniform usampler3D labelTexture;
layout(std430, binding = kLabelsOfTilesStorage) writeonly buffer LabelsOfTiles { uint labelsOfTiles[]; };

const int kWords = 8;
shared uint seen[kWords];

void noteLabelsIn(ivec3 first) {
    for (uint left = membersFrom(first); left != 0u; left &= left - 1u) {
        uint label = texelFetch(labelTexture, first + ivec3(findLSB(left), 0, 0), 0).r;
        if ((seen[label >> 5] >> (label & 31u) & 1u) == 0u) {
            atomicOr(seen[label >> 5], 1u << (label & 31u));
        }
    }
}

void main() {
    int index = int(gl_LocalInvocationIndex);
    if (index < kWords) {
        seen[index] = 0u;
    }
    barrier();
    ivec3 origin = tileOrigin(gl_WorkGroupID.y);
    for (int row = index; row < kPadded * kPadded; row += 64) {
        noteLabelsIn(origin + ivec3(0, row % kPadded, row / kPadded) - kReach);
    }
    barrier();
    if (index < kWords) {
        labelsOfTiles[(uint(firstTile) + gl_WorkGroupID.y) * uint(kWords) + uint(index)] = seen[index];
    }
}
