#pragma once

#include "catalog.h"
#include "sensor_link.h"

#include <functional>
#include <optional>
#include <QHash>
#include <QPointer>
#include <QSet>

namespace lds::support {

using catalog::ItemId;
using catalog::Value;

class FakeLink;

/// A sensor in memory behind a FakeLink: what it holds, how it judges, and every way it can misbehave on
/// purpose. Everything happens in the caller's thread; requests and answers travel as posted events, so
/// a test lets them run with settle() (or any event loop) and time stands still meanwhile.
class FakeSensor final {
public:
    explicit FakeSensor(catalog::SensorModel model = catalog::SensorModel::HlG203);

    // --- What it holds; setting a value here is "somebody else did it".
    const settings::Values& values() const { return m_values; }
    Value value(ItemId item) const { return m_values.value(item); }
    void set(ItemId item, Value value) { m_values.insert(item, value); }
    void switchBank(Value bank); ///< 1 … 4; each bank keeps its bank-scoped values.

    // --- How it judges writes
    using Verdict = tl::expected<settings::Values, ports::Failure>;
    using Judge = std::function<Verdict(const settings::Values& state, const settings::Write& write)>;
    /// Instead of settings::apply for settings.
    void setJudge(Judge judge) { m_judge = std::move(judge); }
    void refuse(ItemId item, ports::FailureCode code = ports::FailureCode::ValueRefused);
    void acceptAgain(ItemId item) { m_refused.remove(item); }
    /// In its menu: every request and every poll is refused with NotReady.
    void setNotReady(bool notReady);
    /// Reads are refused with this code; None to stop.
    void refuseReads(ports::FailureCode code) { m_refuseReads = code; }

    // --- Answers that do not come
    enum class Carried { Out, Not };
    /// The next write that touches the item gets no answer until timeOut().
    void loseAnswer(ItemId item, Carried carried) { m_losses.insert(item, carried); }
    /// The next reads get no answer until timeOut().
    void loseReads(int count) { m_lostReads = count; }
    /// Holds every answer until deliver() or timeOut(). Requests are carried out when they are delivered.
    void holdAnswers(bool hold) { m_hold = hold; }
    int outstanding() const { return int(m_waiting.size()); }
    void deliver();       ///< Answers the oldest request that waits.
    void deliverNewest(); ///< The newest one first, as a link does whose queue knows urgencies.
    void deliverAll();
    void timeOut(); ///< Ends every waiting request as Unknown, NoAnswer.
    /// An answer to a request that has ended, or never was.
    void answerLate(ports::RequestId id, const settings::Values& values);

    // --- The connection
    void failOpenings(ports::OpenFailure failure, const QString& detail = {});
    void allowOpenings() { m_openFailure = ports::OpenFailure::None; }
    void cut(); ///< Ends what waits as Unknown, ConnectionLost, and reports Failed, Lost.
    bool isOpen() const { return m_open; }
    void hide(ItemId item) { m_hidden.insert(item); } ///< The protocol does not reach it.

    // --- Measurements
    void emitMeasurement(const measurement::Measurement& sample);
    void emitBatch(const measurement::MeasurementBatch& batch);
    void refusePoll(ports::FailureCode code); ///< None: polls succeed again.
    int pollIntervalMs() const { return m_pollIntervalMs; }

    // --- What it was asked
    const QList<ports::Request>& requests() const { return m_requests; }
    void forgetRequests() { m_requests.clear(); }
    int openings() const { return m_openings; }
    int reads() const { return count(ports::RequestKind::Read); }
    int writes() const { return count(ports::RequestKind::Write); }
    int readsOf(ItemId item) const;
    int writesOf(ItemId item) const; ///< Write requests that touched the item, answered or not.
    /// Runs after every request that arrives, before it is answered.
    void setOnRequest(std::function<void(const ports::Request&)> hook) { m_onRequest = std::move(hook); }

private:
    friend class FakeLink;
    struct Waiting {
        ports::Request request;
        std::optional<Carried> lost;
    };

    void opening(FakeLink* link);
    void closing();
    void arrived(const ports::Request& request);
    void answer(const ports::Request& request);
    void end(const ports::Request& request, ports::Status status, ports::FailureCode code,
             const settings::Values& values = {});
    ports::Failure carryOut(const settings::Write& write);
    void carryOutCommand(ItemId item, Value value);
    int count(ports::RequestKind kind) const;

    catalog::SensorModel m_model;
    settings::Values m_defaults;
    settings::Values m_values;
    QHash<int, settings::Values> m_banks;
    Judge m_judge;
    QMap<ItemId, ports::FailureCode> m_refused;
    QMap<ItemId, Carried> m_losses;
    QSet<ItemId> m_hidden;
    QList<Waiting> m_waiting;
    QList<ports::Request> m_requests;
    std::function<void(const ports::Request&)> m_onRequest;
    QPointer<FakeLink> m_link;
    ports::FailureCode m_refuseReads = ports::FailureCode::None;
    ports::OpenFailure m_openFailure = ports::OpenFailure::None;
    QString m_openDetail;
    ports::PollStatistics m_statistics;
    int m_lostReads = 0;
    int m_openings = 0;
    int m_pollIntervalMs = 0;
    bool m_hold = false;
    bool m_notReady = false;
    bool m_open = false;
};

} // namespace lds::support
