# What the renderer is made with, and the grader as well.
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(PNG REQUIRED)
find_package(TBB REQUIRED)
find_package(tinyobjloader REQUIRED)
find_package(tomlplusplus REQUIRED)
