// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The module certify: proofs that a curve is safe.

#include "tutavia/certify/certificate.hpp"
#include "tutavia/certify/certify.hpp"
#include "tutavia/certify/certify_vehicle.hpp"
#include "tutavia/certify/piece_proof.hpp"
#include "tutavia/certify/revalidate.hpp"
