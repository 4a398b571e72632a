// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours/VerletSkin.hpp"

#include "base/boundingBox.hpp"
#include "base/parallel.hpp"
#include "particles/reduce.hpp"

#include <functional>

namespace slosh
{

namespace
{

/// 0 where it is not a number: the step that follows finds that out and says so.
double speedOf(const Vec& v)
{
    const double speed = v.norm();
    return std::isfinite(speed) ? speed : 0;
}

struct Speeds
{
    double sum = 0, largest = 0;
};

Speeds speedsOf(const Particles& particles)
{
    return reduceLiquid(
        particles, Speeds{},
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            Speeds speeds;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                const double speed = speedOf(particles.v[i]);
                speeds.sum += speed;
                speeds.largest = std::max(speeds.largest, speed);
            }
            return speeds;
        },
        [](const Speeds& a, const Speeds& b) {
            return Speeds{a.sum + b.sum, std::max(a.largest, b.largest)};
        }
    );
}

} // namespace

void VerletSkin::choose(const Particles& particles, bool wallsMove, double supportRadius, double dt)
{
    const Speeds speeds = speedsOf(particles);
    const double mean = speeds.sum / static_cast<double>(std::max<std::ptrdiff_t>(particles.nFluid, 1));
    const double third = cheapest(supportRadius, 2 * mean * dt) / 3;
    wallsMove_ = wallsMove;
    skins_.resize(particles.r.size());
    parallelFor(
        particles.size(),
        [&](std::ptrdiff_t i)
        {
            const double speed = speedOf(particles.v[i]);
            const double own = third * ((mean > 0 ? speed / mean : 0) + 1.5);
            const bool moves = wallsMove || i < particles.nFluid;
            skins_[i] =
                moves ? std::max(std::min(own, 0.3 * supportRadius), dt * speed) + dt * speeds.largest / 2 : 0.0;
        }
    );
    largest_ = *std::max_element(skins_.begin(), skins_.end());
}

void VerletSkin::listBuilt(const Particles& particles)
{
    const BoundingBox box = boundingBox(particles.r);
    origin_ = box.center();
    rounding_ = 2e-7 * box.diagonal().norm();
    const std::ptrdiff_t moving = wallsMove_ ? particles.size() : particles.nFluid;
    listed_.resize(moving);
    parallelFor(moving, [&](std::ptrdiff_t i) { listed_[i] = (particles.r[i] - origin_).cast<float>(); });
}

bool VerletSkin::mustRebuild(const Particles& particles, double dt, double maxSpeed) const
{
    const std::ptrdiff_t moving = wallsMove_ ? particles.size() : particles.nFluid;
    if (std::ssize(listed_) != moving)
    {
        return true;
    }
    const double whenHit = maxSpeed / 2;
    const std::ptrdiff_t tooFar = parallelReduce(
        moving, std::ptrdiff_t(0),
        [&](std::ptrdiff_t begin, std::ptrdiff_t end)
        {
            std::ptrdiff_t count = 0;
            for (std::ptrdiff_t i = begin; i < end; ++i)
            {
                const double moved2 = (particles.r[i] - origin_ - listed_[i].cast<double>()).squaredNorm();
                const double skin = skins_[i] - rounding_;
                if (const double least = skin - dt * (maxSpeed + whenHit); least > 0 && moved2 <= least * least)
                {
                    continue; // enough for the fastest, and no root
                }
                const double room = skin - dt * (speedOf(particles.v[i]) + whenHit);
                count += room < 0 || moved2 > room * room;
            }
            return count;
        },
        std::plus<>()
    );
    return tooFar > 0;
}

} // namespace slosh
