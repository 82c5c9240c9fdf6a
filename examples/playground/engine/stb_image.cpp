// SPDX-License-Identifier: MIT
// stb_image as a part of the engine in the page: no library of the machine can be linked there.
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#include <stb/stb_image.h>
