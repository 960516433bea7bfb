// Where programs of this module find their resources: the numbers of the bindings, for GLSL and C++ alike,
// which is why there is nothing else in here. Numbers of one kind that one program uses differ; programs that
// do not meet share them.

// Texture units.
const int kOutlineDistancesTexture = 0;
const int kWholeSculptureTexture = 0;
const int kOwnDepthsTexture = 1;
const int kUpToTexture = 1;
const int kBeforeTexture = 1;
const int kFromTexture = 2;
const int kFrontDepthsTexture = 2;
const int kLimitsTexture = 3;
const int kLeftForToolsTexture = 3;

// Image units.
const int kSculptureCellsImage = 0;
const int kDepositsImage = 0;
const int kEnergyImage = 0;
const int kPartImage = 0;
const int kRegionImage = 0;
const int kSolidSculptureImage = 0;
const int kLeftForToolsImage = 0;
const int kEnergiesImage = 1;
const int kSculptureImage = 1;
const int kSourceImage = 1;
const int kEarlierImage = 2;
const int kResultImage = 2;

// Storage blocks.
const int kCornersStorage = 0;
const int kIslandsStorage = 0;
const int kMarkedTilesStorage = 0;
const int kPointsStorage = 0;
const int kSummaryStagesStorage = 0;
const int kTileListStorage = 0;
const int kChangedStorage = 1;
const int kKeptStorage = 1;
const int kMarksStorage = 1;
const int kPatchesStorage = 1;
const int kStagesStorage = 1;
const int kWaysStorage = 1;
const int kIslandBoundsStorage = 2;
const int kListXStorage = 2;
const int kReachStorage = 2;
const int kToolPointsStorage = 2;
const int kListYStorage = 3;
const int kListZStorage = 4;
const int kTileBoundsStorage = 5;
