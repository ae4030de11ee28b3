#pragma once

#include "sensor_link.h"

#include <functional>
#include <QHash>
#include <QObject>
#include <QPointer>

namespace lds::sensor {

/// The session's end of one link: brings its signals into the session's thread and each answer to the
/// one who asked. An answer nobody waits for any more is dropped. Made anew for every open(), so that
/// nothing of an earlier connection can arrive in a later one.
class LinkClient final : public QObject {
    Q_OBJECT

public:
    using Handler = std::function<void(const ports::Outcome&)>;

    LinkClient(ports::LinkPointer link, QObject* parent);
    ~LinkClient() override;

    bool reaches(catalog::ItemId item) const { return m_link && m_link->reaches(item); }
    void open();
    void poll(int intervalMs);
    /// Chooses the request's id. `handler` runs at most once, and not at all when `context` has died or
    /// forgetRequests() came first.
    void submit(ports::Request request, QObject* context, Handler handler);
    void forgetRequests() { m_waiting.clear(); }
    /// Closes and gives back the link; not a word comes from here afterwards. Deletes itself later.
    void shutDown();

Q_SIGNALS:
    void reported(const lds::ports::LinkReport& report);
    void measured(const lds::measurement::MeasurementBatch& batch,
                  const lds::ports::PollStatistics& statistics);
    void pollRefused(const lds::ports::Failure& failure);

private:
    struct Waiting {
        QPointer<QObject> context;
        Handler handler;
    };

    void finish(const ports::Outcome& outcome);

    ports::LinkPointer m_link;
    QHash<ports::RequestId, Waiting> m_waiting;
    ports::RequestId m_nextId = 1;
};

} // namespace lds::sensor
