# Everything comes from Debian 12's packages; packaging/dependencies.txt lists them.
find_package(Threads REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(OpenCV REQUIRED COMPONENTS core imgproc imgcodecs)
find_package(embree 3 REQUIRED)
find_package(SQLiteCpp REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(Qt5 5.15 REQUIRED COMPONENTS Core Gui Widgets Svg Test)
find_package(VTK 9.1 REQUIRED COMPONENTS
    CommonCore CommonDataModel CommonTransforms FiltersCore FiltersGeneral FiltersSources GUISupportQt ImagingCore
    InteractionStyle InteractionWidgets IOImage RenderingAnnotation RenderingCore RenderingFreeType RenderingLabel
    RenderingOpenGL2)

# PCL's own CMake package pulls VTK into every PCL target. Only the modules that need no VTK are used,
# so they are taken from pkg-config, and core stays free of VTK.
find_package(PkgConfig REQUIRED)
pkg_check_modules(PCL REQUIRED IMPORTED_TARGET pcl_common)

if(FODSCOPE_BUILD_TESTS)
    find_package(GTest REQUIRED)
    find_package(benchmark REQUIRED)
endif()
