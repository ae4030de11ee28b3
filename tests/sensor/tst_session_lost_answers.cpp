#include "session_fixture.h"

using namespace lds::sensor;
using lds::ports::FailureCode;
using lds::ports::Request;
using lds::ports::RequestKind;
using lds::ports::Status;
using lds::support::FakeSensor;
using lds::support::settle;

/// Answers that do not come, and connections that break while a setting is being written.
class SessionLostAnswersTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Design: a lost reply to a write is never answered by writing again. Every setting there is.
    void aLostAnswerIsNeverWrittenAgain_data()
    {
        QTest::addColumn<ItemId>("item");
        QTest::addColumn<bool>("carriedOut");
        for (const auto& item : lds::catalog::Catalog::hlG2().items()) {
            if (item.role != lds::catalog::Role::Setting || !item.isWritable())
                continue;
            QTest::addRow("%s, carried out", item.key) << item.id << true;
            QTest::addRow("%s, not carried out", item.key) << item.id << false;
        }
    }
    void aLostAnswerIsNeverWrittenAgain()
    {
        QFETCH(ItemId, item);
        QFETCH(bool, carriedOut);
        SessionFixture f;
        prepareNetworkFor(item, f.sensor());
        f.openReady();
        const Value other = otherValue(f, item);
        QVERIFY2(other != *f.session->held(item), "the test finds no other value");
        f.edit(item, other);
        QVERIFY2(f.session->plan(), "the test's own choice of a value");
        f.sensor().loseAnswer(item, carriedOut ? FakeSensor::Carried::Out : FakeSensor::Carried::Not);
        f.applyAndSettle();
        QCOMPARE(f.sensor().outstanding(), 1);
        QVERIFY(f.session->isApplying());
        f.sensor().timeOut();
        settle();
        f.passWalk();
        QCOMPARE(f.sensor().writesOf(item), 1);
        QCOMPARE(f.applies.size(), 1);
        if (carriedOut) { // found by reading
            QVERIFY(f.applies.first().allDone());
            QVERIFY(!f.session->pending().find(item));
            QCOMPARE(f.session->saved(), Saved::NotSaved);
        } else {
            QVERIFY(writtenItems(f.applies.first().unknown).contains(item));
            QCOMPARE(f.wanted(item), other);
            QVERIFY(!f.applies.first().unknown.first().readBack.isEmpty());
        }
        QCOMPARE(f.session->held(item), std::optional(f.sensor().value(item)));
    }

    void theOthersGoOnAfterALostAnswer()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit(tenEdits);
        f.sensor().loseAnswer(ItemId::Offset, FakeSensor::Carried::Not);
        f.applyAndSettle();
        f.sensor().timeOut();
        settle();
        QCOMPARE(writtenItems(f.applies.value(0).unknown), QList{ItemId::Offset});
        QCOMPARE(f.applies.value(0).written.size(), 9);
        QCOMPARE(f.session->pending().edits().keys(), QList{ItemId::Offset});
    }

    void aReadBackWithoutAnswerIsRepeatedButNotForEver()
    {
        SessionFixture f;
        f.openReady();
        f.edit(ItemId::Span, 20000);
        f.sensor().loseReads(1);
        f.applyAndSettle();
        f.sensor().timeOut();
        settle();
        f.pass(300);
        QVERIFY(f.applies.value(0).allDone());
        QCOMPARE(f.sensor().writesOf(ItemId::Span), 1);

        f.edit(ItemId::Span, 30000);
        f.sensor().loseReads(1000);
        f.applyAndSettle();
        for (int i = 0; i < 10 && f.applies.size() < 2; ++i) {
            f.sensor().timeOut();
            settle();
            f.pass(300);
        }
        QCOMPARE(f.applies.size(), 2);
        QCOMPARE(writtenItems(f.applies.last().unknown), QList{ItemId::Span});
        QVERIFY(f.applies.last().unknown.first().readBack.isEmpty());
        QCOMPARE(f.wanted(ItemId::Span), 30000);
        QCOMPARE(f.session->saved(), Saved::NotSaved);
        QCOMPARE(f.sensor().writesOf(ItemId::Span), 2);
    }

    void aCutInTheMiddleStopsAndKeepsWhatIsNotDone()
    {
        SessionFixture f;
        f.openReady();
        f.session->edit(tenEdits);
        int writes = 0;
        f.sensor().setOnRequest([&](const Request& request) {
            if (request.kind == RequestKind::Write && ++writes == 4)
                f.sensor().cut();
        });
        f.applyAndSettle();
        QCOMPARE(f.applies.size(), 1);
        const ApplyReport report = f.applies.first();
        QVERIFY(report.connectionLost);
        QCOMPARE(report.written.size(), 3);
        QCOMPARE(report.unknown.size(), 1);
        QCOMPARE(report.notTried.size(), 6);
        QCOMPARE(f.session->pending().count(), 7);
        QCOMPARE(f.session->connection(), Connection::Reconnecting);
        f.sensor().setOnRequest({});
        f.pass(500);
        QVERIFY(f.session->isReady());
        f.passWalk();
        QCOMPARE(f.sensor().writes(), 4); // reconnecting writes nothing
        QCOMPARE(f.session->pending().count(), 7);
        QCOMPARE(f.applies.size(), 1);
        f.applyAndSettle();
        QVERIFY(f.applies.last().allDone());
        for (const auto& each : tenEdits)
            QCOMPARE(f.sensor().value(each.item), each.value);
    }

    /// The write went through, the connection did not: reading again after the cut shows it.
    void anEditCarriedOutJustBeforeTheCutComesTrueByReading()
    {
        SessionFixture f;
        f.openReady();
        f.edit(ItemId::Span, 20000);
        f.sensor().loseAnswer(ItemId::Span, FakeSensor::Carried::Out);
        f.applyAndSettle();
        f.sensor().cut();
        settle();
        QVERIFY(f.applies.value(0).connectionLost);
        QVERIFY(f.session->pending().find(ItemId::Span));
        f.pass(500);
        QVERIFY(f.session->isReady());
        QVERIFY(f.session->pending().isEmpty());
        QCOMPARE(f.sensor().writesOf(ItemId::Span), 1);
    }

private:
    /// An address in which one octet can be changed by itself.
    static void prepareNetworkFor(ItemId item, FakeSensor& sensor)
    {
        const QList masks{ItemId::SubnetMask1stOctet, ItemId::SubnetMask2ndOctet, ItemId::SubnetMask3rdOctet,
                          ItemId::SubnetMask4thOctet};
        const auto setMask = [&](Value first, Value second, Value third) {
            sensor.set(masks[0], first);
            sensor.set(masks[1], second);
            sensor.set(masks[2], third);
            sensor.set(masks[3], 0);
        };
        const auto group = lds::catalog::hlG2(item).group;
        if (group == lds::catalog::WriteGroup::DefaultGateway)
            return setMask(128, 0, 0); // nearly everything is one network
        if (group != lds::catalog::WriteGroup::None) {
            for (const ItemId octet : {ItemId::DefaultGateway1stOctet, ItemId::DefaultGateway2ndOctet,
                                       ItemId::DefaultGateway3rdOctet, ItemId::DefaultGateway4thOctet})
                sensor.set(octet, 0);
        }
        if (item == ItemId::SubnetMask1stOctet)
            setMask(255, 0, 0);
        if (item == ItemId::SubnetMask2ndOctet)
            setMask(255, 255, 0);
    }

    /// Another legal value, such that the rules find a way there.
    static Value otherValue(SessionFixture& f, ItemId id)
    {
        const auto& item = lds::catalog::hlG2(id);
        const Value now = *f.session->held(id);
        const auto& limits = item.limitsFor(f.session->model());
        QList<Value> candidates;
        for (const auto& choice : item.choices) {
            if (choice.models & lds::catalog::maskOf(f.session->model()))
                candidates.append(choice.code);
        }
        candidates += {now + limits.resolution, now - limits.resolution, 0, 1, 128, 192, 254, 255};
        for (const Value value : std::as_const(candidates)) {
            if (value == now || value < limits.minimum || value > limits.maximum)
                continue;
            const auto plan =
                lds::settings::planWrites(f.session->model(), f.session->heldValues(), {{id, value}});
            // One write of the item, so that it can be counted.
            if (plan && std::count_if(plan->steps.begin(), plan->steps.end(),
                                      [id](const auto& step) { return itemsOf(step).contains(id); }) == 1)
                return value;
        }
        return now;
    }
};

QTEST_GUILESS_MAIN(SessionLostAnswersTest)
#include "tst_session_lost_answers.moc"
