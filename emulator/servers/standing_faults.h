#pragma once

namespace lds::emulator {

/// What goes wrong with every answer for as long as it is set.
struct StandingFaults {
    int answerDelayMs = 0;           ///< Answers come so much later.
    bool answersLost = false;        ///< Requests are carried out and not answered.
    bool answersCut = false;         ///< The last two bytes of each answer never come.
    bool connectionsDropped = false; ///< Nothing is taken or answered; connections end, and new ones at once.
    bool operator==(const StandingFaults&) const = default;
};

/// Whoever answers for a virtual sensor, and can be made to do it badly.
class FaultyServer {
public:
    virtual ~FaultyServer() = default;
    virtual void setStandingFaults(const StandingFaults& faults) = 0;

protected:
    FaultyServer() = default;
    FaultyServer(const FaultyServer&) = default;
    FaultyServer& operator=(const FaultyServer&) = default;
};

} // namespace lds::emulator
