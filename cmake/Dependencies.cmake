# What the libraries are built on; docs/dependencies.md says why.
find_package(TBB REQUIRED)
find_package(X11 REQUIRED COMPONENTS Xext)
find_package(PNG REQUIRED)
find_path(GLM_INCLUDE_DIR glm/glm.hpp REQUIRED)
find_path(EGL_INCLUDE_DIR EGL/egl.h REQUIRED)
find_package(hwy REQUIRED)
