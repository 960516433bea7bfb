// Where the first texel of a tile of one segment alone lies, by its page.
#include "field/shaders/apart_tiles.glsl"

ivec3 placeOf(uint page) {
    return kApartPadded * ivec3(uvec3(page >> kPagePlaceShift, page >> (kPagePlaceShift + 8),
                                      page >> (kPagePlaceShift + 16)) &
                                255u);
}
