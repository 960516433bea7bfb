// What of the sculpture belongs to one pasted part: min(S, S at its own paste, 1 - S at the paste before),
// and no more than what trims left for tools.
// variants: SCULPTURE_BITS=16
// In: textures 0 sculpture, 1 at its own paste, 2 at the paste before, 3 what is left for tools. Out: image 0
// the part.
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;

#include "gl/shaders/place.glsl"

#include "sculpt/shaders/bindings.glsl"
layout(binding = kWholeSculptureTexture) uniform sampler3D sculpture;
layout(binding = kUpToTexture) uniform sampler3D upTo;
layout(binding = kFromTexture) uniform sampler3D from;
layout(binding = kLeftForToolsTexture) uniform sampler3D leftForTools;
#include "sculpt/shaders/stored_values.glsl"

layout(SCULPTURE_FORMAT, binding = kPartImage) uniform writeonly image3D part;

uniform ivec3 first;
uniform ivec3 last; // exclusive
uniform ivec3 has;  // x: there is an end, y: there is a beginning, z: without what was trimmed

void main() {
    ivec3 voxel = first + placeOfInvocation();
    if (any(greaterThanEqual(voxel, last))) {
        return;
    }
    float value = texelFetch(sculpture, voxel, 0).r;
    value = has.x != 0 ? min(value, texelFetch(upTo, voxel, 0).r) : value;
    value = has.y != 0 ? min(value, 1.0 - texelFetch(from, voxel, 0).r) : value;
    value = has.z != 0 ? min(value, texelFetch(leftForTools, voxel, 0).r) : value;
    imageStore(part, voxel, vec4(value));
}
