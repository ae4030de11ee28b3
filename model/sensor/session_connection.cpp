#include "session_core.h"

namespace lds::sensor {

using ports::FailureCode;
using ports::LinkState;
using ports::OpenFailure;

void SensorSession::Private::open()
{
    if (connection != Connection::Closed)
        return;
    reconnecting = ReconnectPolicy(timing.reconnectFirstMs, timing.reconnectLongestMs);
    client = new LinkClient(links.create(url), q);
    const auto inTurn = [this](auto work) {
        return [this, work](const auto&... arguments) {
            Turn turn(*this);
            (this->*work)(arguments...);
        };
    };
    QObject::connect(client, &LinkClient::reported, client, inTurn(&Private::reported));
    QObject::connect(client, &LinkClient::measured, client, inTurn(&Private::measured));
    QObject::connect(client, &LinkClient::pollRefused, client, inTurn(&Private::pollRefused));

    reachable.clear();
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items()) {
        if (client->reaches(item.id))
            reachable.insert(item.id);
    }
    settingsWalk = SettingsWalk(readableItems(true));
    report = {LinkState::Opening, OpenFailure::None, {}, true};
    setConnection(Connection::Opening);
    client->open();
}

void SensorSession::Private::close()
{
    if (connection == Connection::Closed)
        return;
    stopTimer(retryTimer);
    stopTimer(rereadTimer);
    stopTimer(walkTimer);
    voidReadings();
    client->shutDown();
    client = nullptr;
    report = {LinkState::Closed, OpenFailure::None, {}, true};
    latest.reset();
    rate.clear();
    setNotReady(false);
    setSaved(Saved::Unknown);
    setConnection(Connection::Closed);
    endRuns();
}

void SensorSession::Private::tryAgain()
{
    stopTimer(retryTimer);
    if (client)
        client->open();
}

void SensorSession::Private::reported(const ports::LinkReport& next)
{
    switch (next.state) {
    case LinkState::Opening:
        report.state = next.state; // a new try does not make forget why the last one failed
        announcer.add(Announcer::News::Connection);
        break;
    case LinkState::Open:
        report = next;
        startReading();
        break;
    case LinkState::Failed:
        connectionGone(next);
        break;
    case LinkState::Closed:
        break; // only ever by close(), after which nobody listens
    }
}

void SensorSession::Private::connectionGone(const ports::LinkReport& next)
{
    report = next;
    announcer.add(Announcer::News::Connection);
    stopTimer(rereadTimer);
    stopTimer(walkTimer);
    client->forgetRequests();
    voidReadings();
    latest.reset();
    rate.clear();
    announcer.add(Announcer::News::Measured);
    setNotReady(next.failure == OpenFailure::NotReady);
    setConnection(Connection::Reconnecting);
    endRuns();
    stopTimer(retryTimer);
    startTimer(retryTimer, reconnecting.nextDelayMs(next.failure), &Private::tryAgain);
}

void SensorSession::Private::startReading()
{
    stopTimer(retryTimer);
    setNotReady(false);
    setSaved(Saved::Unknown); // it may have been switched off meanwhile
    readEverything();
}

void SensorSession::Private::readEverything()
{
    stopTimer(rereadTimer);
    setConnection(Connection::Reading);
    ports::Request request;
    request.kind = ports::RequestKind::Read;
    request.urgency = ports::Urgency::Person;
    request.items = readableItems(false);
    ask(request, client, [this](const ports::Outcome& outcome) { everythingRead(outcome); });
}

void SensorSession::Private::everythingRead(const ports::Outcome& outcome)
{
    if (connection != Connection::Reading)
        return;
    if (outcome.status == ports::Status::Done) {
        learn(outcome.values, outcome.finishedNs, {});
        bankIsOther = readAllWanted = false; // all of it has just been read
        return becomeReady();
    }
    if (isConnectionGone(outcome))
        return; // the link's report follows
    if (outcome.status == ports::Status::Refused && outcome.failure.code != FailureCode::NotReady)
        return takeForNoSensor(outcome.failure);
    const bool inMenu = outcome.failure.code == FailureCode::NotReady;
    setNotReady(inMenu);
    const int delay = reconnecting.nextDelayMs(inMenu ? OpenFailure::NotReady : OpenFailure::NoAnswer);
    startTimer(rereadTimer, delay, &Private::readEverything);
}

/// It passed the link's probe and yet refuses items that every HL-G2 lets read.
void SensorSession::Private::takeForNoSensor(const ports::Failure& failure)
{
    report.state = LinkState::Failed;
    report.failure = OpenFailure::NotASensor;
    report.detail = failure.detail;
    announcer.add(Announcer::News::Connection);
    setNotReady(false);
    setConnection(Connection::Reconnecting);
    startTimer(rereadTimer, reconnecting.nextDelayMs(report.failure), &Private::readEverything);
}

void SensorSession::Private::becomeReady()
{
    reconnecting.reset();
    report.state = LinkState::Open;
    report.failure = OpenFailure::None;
    report.detail.clear();
    setNotReady(false);
    setConnection(Connection::Ready);
    client->poll(timing.pollIntervalMs);
    startTimer(walkTimer, timing.walkIntervalMs, &Private::walk);
}

void SensorSession::Private::setConnection(Connection next)
{
    if (std::exchange(connection, next) != next)
        announcer.add(Announcer::News::Connection);
}

void SensorSession::Private::setNotReady(bool next)
{
    if (std::exchange(notReady, next) != next)
        announcer.add(Announcer::News::Readiness);
}

void SensorSession::Private::startTimer(ports::Scheduler::TimerId& timer, int delayMs,
                                        void (Private::*callback)())
{
    scheduler.cancel(timer);
    timer = scheduler.after(delayMs, q, [this, &timer, callback] {
        Turn turn(*this);
        timer = 0;
        (this->*callback)();
    });
}

void SensorSession::Private::stopTimer(ports::Scheduler::TimerId& timer)
{
    if (timer != 0)
        scheduler.cancel(std::exchange(timer, 0));
}

void SensorSession::Private::measured(const measurement::MeasurementBatch& batch,
                                      const ports::PollStatistics& polls)
{
    if (connection != Connection::Ready || batch.isEmpty())
        return;
    statistics = polls;
    for (const measurement::Measurement& sample : batch)
        trend.append(sample);
    latest = batch.last();
    rate.add(batch);
    setNotReady(false);
    announcer.add(Announcer::News::Measured);
}

void SensorSession::Private::pollRefused(const ports::Failure& failure)
{
    if (connection != Connection::Ready)
        return;
    if (failure.code == FailureCode::NotReady)
        setNotReady(true);
    else if (failure.code == FailureCode::None)
        setNotReady(false);
}

} // namespace lds::sensor
