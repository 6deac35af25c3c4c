// Stands in for OpenSSL's header in the preset windows: the one digest that is used here, by Windows itself (bcrypt.dll).
#pragma once

#include <cstddef>

struct EVP_MD {};
struct ENGINE;

const EVP_MD* EVP_sha256();
int EVP_Digest(const void* data, std::size_t count, unsigned char* digest, unsigned int* size,
               const EVP_MD* kind, ENGINE* engine);
