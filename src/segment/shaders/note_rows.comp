// Before growth goes over to rows of tiles that are tested whole: notes those that the tiles at work lie in.
// One invocation a tile. In and out: storage 5 expansions[0], 6 work.
#include "segment/shaders/words.glsl"
#include "segment/shaders/active_tiles.glsl"

layout(local_size_x = 16) in;

void main() {
    uint count = expansions[0].tiles.w;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += gl_NumWorkGroups.x * kTilesPerGroup) {
        noteRowOf(work[listStart(listNoted) + i]);
    }
}
