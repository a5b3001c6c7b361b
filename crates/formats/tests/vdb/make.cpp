// Writes the `.vdb` files of this folder with OpenVDB itself, and what OpenVDB reads back from each as `.npy` files.
// See README.md.
#include <openvdb/openvdb.h>
#include <openvdb/io/Stream.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/LevelSetUtil.h>
#include <fstream>
#include <iostream>

using namespace openvdb;
using io::COMPRESS_ACTIVE_MASK, io::COMPRESS_BLOSC, io::COMPRESS_NONE, io::COMPRESS_ZIP;

// A number of the voxel, in 1/64: exact in half precision, too.
float number(const Coord& c) {
    const uint32_t mixed = uint32_t(c.x() * 73856093) ^ uint32_t(c.y() * 19349663) ^ uint32_t(c.z() * 83492791);
    return float(mixed % 997 + 1) / 64;
}

// The values of a box, both corners included, as OpenVDB reads them: [z][y][x], single precision.
void expect(const FloatGrid& grid, const CoordBBox& box, const std::string& name) {
    const Coord size = box.dim();
    std::string about = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + std::to_string(size.z()) + ", " +
                        std::to_string(size.y()) + ", " + std::to_string(size.x()) + "), }";
    about.resize((about.size() + 11 + 63) / 64 * 64 - 11, ' ');
    about += '\n';
    std::ofstream out(name + ".npy", std::ios::binary);
    out.write("\x93NUMPY\x01", 7);
    out.put(0).put(char(about.size() & 255)).put(char(about.size() >> 8)) << about;
    auto values = grid.getConstAccessor();
    for (int z = box.min().z(); z <= box.max().z(); ++z)
        for (int y = box.min().y(); y <= box.max().y(); ++y)
            for (int x = box.min().x(); x <= box.max().x(); ++x) {
                const float value = values.getValue(Coord(x, y, z));
                out.write(reinterpret_cast<const char*>(&value), 4);
            }
}

// What OpenVDB reads of the only grid of a file, over a box or all that is active.
void expect_file(const std::string& name, CoordBBox box = CoordBBox()) {
    io::File file(name + ".vdb");
    file.open(/*delayLoad=*/false);
    const auto grid = gridPtrCast<FloatGrid>(file.readGrid(file.beginName().gridName()));
    if (box.empty()) box = grid->evalActiveVoxelBoundingBox();
    std::cout << name << ": " << box << " background " << grid->background() << std::endl;
    expect(*grid, box, name);
}

void write(const std::string& name, uint32_t compression, const GridCPtrVec& grids) {
    io::File file(name + ".vdb");
    file.setCompression(compression);
    file.write(grids);
    file.close();
}

FloatGrid::Ptr grid_of(float background) {
    auto grid = FloatGrid::create(background);
    grid->setName("density");
    return grid;
}

// A box full of numbers, across the borders of leaves.
FloatGrid::Ptr dense() {
    auto grid = grid_of(0);
    auto values = grid->getAccessor();
    const CoordBBox box(Coord(4, 13, 20), Coord(13, 19, 28));
    for (auto c = box.begin(); c; ++c) values.setValue(*c, number(*c));
    grid->setTransform(math::Transform::createLinearTransform(0.25));
    return grid;
}

// Eight leaves in two children of the root, each with other kinds of inactive values.
FloatGrid::Ptr sparse() {
    auto grid = grid_of(0.375);
    auto values = grid->getAccessor();
    // One voxel in three is active; the inactive ones take these values in turn.
    const std::vector<std::vector<float>> inactive = {
        {0.375}, {-0.375}, {2}, {-0.375, 0.375}, {0.375, 3}, {2, 3}, {2, 3, 4}, {}};
    for (int k = 0; k < 8; ++k) {
        const Coord corner(k & 1 ? 0 : -8, k & 2 ? 8 : 0, k & 4 ? 8 : 0);
        int turn = 0;
        for (auto c = CoordBBox::createCube(corner, 8).begin(); c; ++c) {
            const auto& own = inactive[k];
            const uint32_t mixed = uint32_t(number(*c) * 64);
            if (own.empty() || mixed % 3 == 0) values.setValue(*c, number(*c));
            else values.setValueOff(*c, own[turn++ % own.size()]);
        }
    }
    return grid;
}

// Active tiles of 8 and 128 voxels, inactive ones of a value of their own, one below the root of 4096, and a leaf.
FloatGrid::Ptr tiles() {
    auto grid = grid_of(0.5);
    auto& tree = grid->tree();
    tree.addTile(1, Coord(16, 0, 0), 1.5, true);
    tree.addTile(1, Coord(24, 8, 0), 2.5, false);
    tree.addTile(1, Coord(16, 8, 8), 3.5, true);
    tree.addTile(2, Coord(128, 0, 0), 4.5, true);
    tree.addTile(2, Coord(128, 128, 0), 5.5, false);
    tree.addTile(3, Coord(4096, 0, 0), 6.5, true);
    tree.addTile(3, Coord(0, -4096, 0), 7.5, false);
    tree.setValue(Coord(3, 2, 1), 8.5);
    return grid;
}

// The borders of tiles of every size.
const CoordBBox TILES(Coord(0, -2, 0), Coord(33, 17, 17));
const CoordBBox FAR_TILES(Coord(4090, 126, 1), Coord(4099, 131, 2));

FloatGrid::Ptr as_half(FloatGrid::Ptr grid) {
    grid->setSaveFloatAsHalf(true);
    return grid;
}

FloatGrid::Ptr fog() {
    auto grid = tools::createLevelSetSphere<FloatGrid>(3.0, Vec3f(4, 5, 6), 0.5, 3.0);
    tools::sdfToFogVolume(*grid);
    grid->setName("density");
    return grid;
}

// One tree under every kind of map.
GridCPtrVec maps() {
    auto tree = grid_of(0);
    tree->tree().setValue(Coord(1, 2, 3), 1.5);
    tree->tree().setValue(Coord(2, 4, 6), 2.5);
    using namespace math;
    const Mat4d turned = Mat4d(0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1);
    const Mat4d straight = Mat4d(2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 5, 6, 7, 1);
    const std::vector<std::pair<std::string, MapBase::Ptr>> all = {
        {"uniform_scale", MapBase::Ptr(new UniformScaleMap(0.5))},
        {"scale", MapBase::Ptr(new ScaleMap(Vec3d(0.5, 1, 2)))},
        {"translation", MapBase::Ptr(new TranslationMap(Vec3d(5, 6, 7)))},
        {"uniform_scale_translate", MapBase::Ptr(new UniformScaleTranslateMap(0.5, Vec3d(5, 6, 7)))},
        {"scale_translate", MapBase::Ptr(new ScaleTranslateMap(Vec3d(0.5, 1, 2), Vec3d(5, 6, 7)))},
        {"straight_affine", MapBase::Ptr(new AffineMap(straight))},
        {"turned_affine", MapBase::Ptr(new AffineMap(turned))},
        {"mirrored", MapBase::Ptr(new ScaleMap(Vec3d(-1, 1, 1)))},
        {"unitary", MapBase::Ptr(new UnitaryMap(Vec3d(0, 0, 1), 0.5))},
        {"frustum", MapBase::Ptr(new NonlinearFrustumMap(BBoxd(Vec3d(0), Vec3d(10)), 0.5, 1.0))},
    };
    GridCPtrVec grids;
    for (const auto& [name, map] : all) {
        auto grid = tree->copy();
        grid->setName(name);
        grid->setTransform(Transform::Ptr(new Transform(map)));
        std::cout << name << ": " << map->type() << ", centre of (1, 2, 3) at " << map->applyMap(Vec3d(1, 2, 3))
                  << std::endl;
        grids.push_back(grid);
    }
    return grids;
}

// Grids of several names and types; two have one name.
GridCPtrVec several() {
    auto density = grid_of(0), heat = grid_of(1), again = grid_of(0), empty = grid_of(0.75);
    density->tree().setValue(Coord(0, 0, 0), 1.5);
    heat->tree().setValue(Coord(0, 0, 0), 2.5);
    heat->setName("heat");
    again->tree().setValue(Coord(0, 0, 0), 3.5);
    empty->setName("empty");
    auto wind = Vec3SGrid::create();
    wind->setName("wind");
    wind->tree().setValue(Coord(0, 0, 0), Vec3f(1, 2, 3));
    auto whole = Int32Grid::create();
    whole->setName("whole");
    whole->tree().setValue(Coord(0, 0, 0), 7);
    return {wind, density, heat, again, empty, whole};
}

int main() {
    initialize();
    write("none", COMPRESS_NONE, {dense()});
    write("mask", COMPRESS_ACTIVE_MASK, {sparse()});
    write("zip", COMPRESS_ZIP, {sparse()});
    write("zip_mask", COMPRESS_ZIP | COMPRESS_ACTIVE_MASK, {sparse()});
    write("blosc", COMPRESS_BLOSC, {dense()});
    write("blosc_mask", COMPRESS_BLOSC | COMPRESS_ACTIVE_MASK, {sparse()});
    write("half_mask", COMPRESS_ACTIVE_MASK, {as_half(sparse())});
    write("half_zip_mask", COMPRESS_ZIP | COMPRESS_ACTIVE_MASK, {as_half(dense())});
    write("half_blosc_mask", COMPRESS_BLOSC | COMPRESS_ACTIVE_MASK, {as_half(sparse())});
    write("fog", COMPRESS_BLOSC | COMPRESS_ACTIVE_MASK, {fog()});
    for (const std::string name : {"none", "mask", "zip", "zip_mask", "blosc", "blosc_mask", "half_mask", "half_zip_mask",
                                   "half_blosc_mask", "fog"})
        expect_file(name);
    write("tiles", COMPRESS_BLOSC | COMPRESS_ACTIVE_MASK, {tiles()});
    write("half_tiles", COMPRESS_ZIP, {as_half(tiles())});
    expect_file("tiles", TILES);
    expect_file("half_tiles", FAR_TILES);
    write("maps", COMPRESS_ACTIVE_MASK, maps());
    write("several", COMPRESS_ZIP | COMPRESS_ACTIVE_MASK, several());
    std::ofstream stream("stream.vdb", std::ios::binary);
    io::Stream(stream).write({several()[1]});
}
