// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace slosh
{

/// What somebody outside asks a run for, by a signal: SIGUSR1 to write at the end of this step and go on, SIGTERM and
/// SIGINT to write there and stop. A second SIGTERM or SIGINT ends the program at once, as without this.
void listenToSignals();

bool writeRequested(); ///< since it was last asked
int stopSignal();      ///< the signal that asks for the end; 0 as long as none has come

} // namespace slosh
