// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CaseDirectory.hpp"

#include <string>
#include <vector>

namespace slosh
{

/// Whether a shell finds the program.
bool isInstalled(const std::string& program);

/// Runs commands in the case as a user does who has sourced our etc/bashrc: ours and those that are installed. They
/// must not hold a single quote.
Ended runInShell(const CaseDirectory& theCase, const std::string& commands);
/// The same; a test fails that expects it to succeed and it does not.
std::string succeedInShell(const CaseDirectory& theCase, const std::string& commands);

/// A case that the solver has taken to 0.1 s, times 0, 0.05 and 0.1 written in this format ("ascii", 10 digits, or
/// "binary").
class WrittenCase : public CaseDirectory
{
public:
    explicit WrittenCase(const std::string& format);
};

/// What another program has read of the particles of a cloud at a time: for each x y z, U, p, rho, id.
using ParticleRows = std::vector<std::vector<double>>;

/// Expects `read` to be our file's particles in their order, each value the number of single precision nearest to ours,
/// which is what ParaView's reader and foamToVTK keep; positions may be `moved` [m].
void expectOurParticles(
    const CaseDirectory& theCase, const std::string& time, const std::string& cloud, const ParticleRows& read,
    double moved = 0
);

} // namespace slosh
