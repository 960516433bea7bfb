// How tiles of one segment alone lie in a texture (segment::ApartTiles), for GLSL and C++ alike, which is why
// there is nothing else in here. A tile of 16^3 voxels takes 17^3 texels, so that what is between its voxels
// and those of the next ones can be interpolated in it. A page, a number for each tile, has: in bits 0 and 1
// whose the voxels of the tile are, from bit 3 on where the tile lies, in tiles along x, y and z of 8 bits
// each.
const int kApartTile = 16;
const int kApartPadded = 17;
const int kPageWhose = 3;
const int kNothingOfIt = 0;    // others have something there
const int kSharedWithNone = 1; // what all segments have together is what it has
const int kBesideOthers = 2;
const int kPageIsStored = 4;
const int kPagePlaceShift = 3;
const int kPageIsShared = 1 << 27; // what all have together is it, also between the tile and the next ones
