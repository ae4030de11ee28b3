#include "request_queue.h"

#include <QTest>

using namespace lds;
using ports::Urgency;
using scheduling::RequestQueue;

namespace {

ports::Request request(ports::RequestId id, Urgency urgency)
{
    ports::Request made;
    made.id = id;
    made.urgency = urgency;
    return made;
}

/// The id of the request that goes out now, −1 for a poll, 0 for nothing; it ends at once.
qint64 runNext(RequestQueue& queue)
{
    const auto work = queue.take();
    if (!work)
        return 0;
    queue.finished();
    const auto* taken = std::get_if<ports::Request>(&*work);
    return taken ? qint64(taken->id) : -1;
}

} // namespace

class RequestQueueTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void personGoesBeforeProcedureBeforeBackground();
    void equalsKeepTheirOrder();
    void oneIsUnderWayAtATime();
    void pollGoesOnlyWhenNothingElseDoes();
    void tickWhileBusyIsDroppedAndNotMadeUpFor();
    void tickWhileSomethingWaitsIsDropped();
    void tickBeforeTheLastOneWentOutIsDropped();
    void backgroundGetsItsTurnAfterThePersons();
    void clearReturnsWhatWaitsInItsOrder();
};

void RequestQueueTest::personGoesBeforeProcedureBeforeBackground()
{
    RequestQueue queue;
    queue.add(request(1, Urgency::Background));
    queue.add(request(2, Urgency::Procedure));
    queue.add(request(3, Urgency::Person));
    QCOMPARE(runNext(queue), 3);
    QCOMPARE(runNext(queue), 2);
    QCOMPARE(runNext(queue), 1);
    QCOMPARE(runNext(queue), 0);
}

void RequestQueueTest::equalsKeepTheirOrder()
{
    RequestQueue queue;
    for (const ports::RequestId id : {5, 3, 9})
        queue.add(request(id, Urgency::Procedure));
    QCOMPARE(runNext(queue), 5);
    QCOMPARE(runNext(queue), 3);
    QCOMPARE(runNext(queue), 9);
}

void RequestQueueTest::oneIsUnderWayAtATime()
{
    RequestQueue queue;
    queue.add(request(1, Urgency::Background));
    queue.add(request(2, Urgency::Background));
    QVERIFY(queue.take());
    QVERIFY(queue.isBusy());
    queue.add(request(3, Urgency::Person));
    QVERIFY(!queue.take());
    queue.finished();
    QCOMPARE(runNext(queue), 3);
    QCOMPARE(runNext(queue), 2);
}

void RequestQueueTest::pollGoesOnlyWhenNothingElseDoes()
{
    RequestQueue queue;
    QVERIFY(queue.addPoll());
    queue.add(request(1, Urgency::Background));
    QCOMPARE(runNext(queue), 1);
    QCOMPARE(runNext(queue), -1);
    QCOMPARE(queue.droppedPolls(), quint64(0));
}

void RequestQueueTest::tickWhileBusyIsDroppedAndNotMadeUpFor()
{
    RequestQueue queue;
    queue.add(request(1, Urgency::Person));
    QVERIFY(queue.take());
    QVERIFY(!queue.addPoll());
    QVERIFY(!queue.addPoll());
    queue.finished();
    QCOMPARE(runNext(queue), 0);
    QCOMPARE(queue.droppedPolls(), quint64(2));
    QVERIFY(queue.addPoll());
    QCOMPARE(runNext(queue), -1);
}

void RequestQueueTest::tickWhileSomethingWaitsIsDropped()
{
    RequestQueue queue;
    queue.add(request(1, Urgency::Background));
    QVERIFY(!queue.addPoll());
    QCOMPARE(queue.droppedPolls(), quint64(1));
    queue.countDropped(3);
    QCOMPARE(queue.droppedPolls(), quint64(4));
}

void RequestQueueTest::tickBeforeTheLastOneWentOutIsDropped()
{
    RequestQueue queue;
    QVERIFY(queue.addPoll());
    QVERIFY(!queue.addPoll());
    QCOMPARE(runNext(queue), -1);
    QCOMPARE(runNext(queue), 0);
}

void RequestQueueTest::backgroundGetsItsTurnAfterThePersons()
{
    RequestQueue queue;
    queue.add(request(100, Urgency::Background));
    for (ports::RequestId id = 1; id <= 5; ++id) {
        queue.add(request(id, Urgency::Person));
        QVERIFY(!queue.addPoll());
        QCOMPARE(runNext(queue), qint64(id));
    }
    QCOMPARE(runNext(queue), 100);
}

void RequestQueueTest::clearReturnsWhatWaitsInItsOrder()
{
    RequestQueue queue;
    queue.add(request(1, Urgency::Person));
    QVERIFY(queue.take());
    queue.add(request(2, Urgency::Background));
    queue.add(request(3, Urgency::Person));
    const QList<ports::Request> left = queue.clear();
    QCOMPARE(left.size(), 2);
    QCOMPARE(left.at(0).id, ports::RequestId(3));
    QCOMPARE(left.at(1).id, ports::RequestId(2));
    QVERIFY(!queue.isBusy());
    QCOMPARE(runNext(queue), 0);
}

QTEST_GUILESS_MAIN(RequestQueueTest)
#include "tst_request_queue.moc"
