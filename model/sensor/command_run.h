#pragma once

#include "patient_read.h"

namespace lds::sensor {

/// One command, switch or procedure step: written once, then what it changes is read back.
/// An answer that does not come is never followed by a second write: where the sensor shows the item's
/// state, reading tells how it went.
class CommandRun {
public:
    using Finished = std::function<void(const CommandReport&)>;

    CommandRun(RunHost& host, ItemId item, Value value, int memoryTimeoutMs, Finished finished);

    void begin();
    void connectionGone(); ///< Ends at once, as unknown.

private:
    void answered(const ports::Outcome& outcome);
    void readBack(bool carriedOut);
    void readBackEnded(bool carriedOut, const settings::Values& read);
    void noteSaved();
    void finish();

    RunHost& m_host;
    QObject m_context;
    PatientRead m_read;
    CommandReport m_report;
    int m_memoryTimeoutMs;
    Finished m_finished; ///< Empty once it has run.
};

} // namespace lds::sensor
