#include "rtu_link_fixture.h"

#include <functional>
#include <QSignalSpy>
#include <QTimer>

using namespace lds;
using namespace lds::tests;
using catalog::ItemId;
using ports::FailureCode;
using ports::Status;
using Received = ScriptedLine::Received;

namespace {

const QByteArray noiseBytes = QByteArray::fromHex("ff00fe3c");

} // namespace

/// What can go wrong on a line, for every function: no wrong value is shown, every request ends once, and the
/// next one works.
class RtuFaultsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { ports::registerMetaTypes(); }
    void disturbedAnswerIsNeverTaken_data();
    void disturbedAnswerIsNeverTaken();
    void disturbedCoilsAreNeverTaken_data();
    void disturbedCoilsAreNeverTaken();
    void lateAnswerIsNotTheAnswerToTheSameReadAgain_data();
    void lateAnswerIsNotTheAnswerToTheSameReadAgain();
    void lateAnswerInFrontOfTheCoilsIsLeftAside();
    void twoAnswersInOneGoAreNotTakenForOne();
    void lateAnswerOfOneUnitDoesNotHurtAnother();
    void lateAnswerWithNobodyAskingMakesTheUnitDoubtful();
    void secondAnswerIsNotTheAnswerToTheNextRequest();
    void noiseBetweenFramesDoesNoHarm();
    void pollsShowNoValueOfADisturbedAnswer();
    void everyByteFlippedAndEveryByteLost_data();
    void everyByteFlippedAndEveryByteLost();
    void vanishedPortEndsEverythingAtOnce_data();
    void vanishedPortEndsEverythingAtOnce();
};

namespace {

using Disturb = std::function<void(RtuLinkFixture&, const Received&)>;

struct Fault {
    const char* name;
    Disturb disturb;
};

QList<Fault> faults()
{
    return {
        {"byte lost", [](RtuLinkFixture& f,
                         const Received& request) { f.line.send(f.line.goodFrame(request).chopped(1)); }},
        {"first byte lost",
         [](RtuLinkFixture& f, const Received& request) {
             f.line.send(f.line.goodFrame(request).sliced(1));
         }},
        {"byte flipped",
         [](RtuLinkFixture& f, const Received& request) {
             QByteArray bytes = f.line.goodFrame(request);
             bytes[bytes.size() - 3] = char(bytes.at(bytes.size() - 3) ^ 0x10);
             f.line.send(bytes);
         }},
        {"answer of another unit",
         [](RtuLinkFixture& f, const Received& request) {
             f.line.send(ScriptedLine::frame(9, f.line.goodPdu(request)));
         }},
        {"answer to another function",
         [](RtuLinkFixture& f, const Received& request) {
             const QByteArray other = request.function() == 0x03 ? QByteArray::fromHex("0600730001")
                                                                 : QByteArray::fromHex("030400010002");
             f.line.send(ScriptedLine::frame(request.unit, other));
         }},
        {"noise in front",
         [](RtuLinkFixture& f, const Received& request) {
             f.line.send(noiseBytes + f.line.goodFrame(request));
         }},
        {"noise behind",
         [](RtuLinkFixture& f, const Received& request) {
             f.line.send(f.line.goodFrame(request) + noiseBytes);
         }},
        {"noise instead", [](RtuLinkFixture& f, const Received&) { f.line.send(noiseBytes); }},
        {"silence", [](RtuLinkFixture&, const Received&) {}},
        {"answer twice",
         [](RtuLinkFixture& f, const Received& request) {
             const QByteArray bytes = f.line.goodFrame(request);
             f.line.send(bytes + bytes);
         }},
        {"answer too long",
         [](RtuLinkFixture& f, const Received& request) {
             const QByteArray pdu = request.function() == 0x03
                                        ? QByteArray::fromHex("03060001000200030004").first(8)
                                        : QByteArray::fromHex("0600010002");
             f.line.send(ScriptedLine::frame(request.unit, pdu));
         }},
    };
}

struct Work {
    const char* name;
    std::function<ports::RequestId(RtuSubject&)> start;
    bool isWrite;
};

QList<Work> works()
{
    return {{"function 03", [](RtuSubject& s) { return s.read({ItemId::Span}); }, false},
            {"function 06",
             [](RtuSubject& s) {
                 return s.write({{ItemId::OutputDelayTimerSetting, 77}});
             },
             true},
            {"function 10h",
             [](RtuSubject& s) {
                 return s.write({{ItemId::HighSetValue, 12'345}});
             },
             true}};
}

} // namespace

void RtuFaultsTest::disturbedAnswerIsNeverTaken_data()
{
    QTest::addColumn<int>("work");
    QTest::addColumn<int>("fault");
    for (int work = 0; work < works().size(); ++work) {
        for (int fault = 0; fault < faults().size(); ++fault)
            QTest::addRow("%s, %s", works().at(work).name, faults().at(fault).name) << work << fault;
    }
}

void RtuFaultsTest::disturbedAnswerIsNeverTaken()
{
    QFETCH(int, work);
    QFETCH(int, fault);
    RtuLinkFixture f;
    f.openAll();
    const Disturb disturb = faults().at(fault).disturb;
    // A read goes out twice, so both are disturbed: then nothing may be taken at all.
    for (int i = 0; i < (works().at(work).isWrite ? 1 : 2); ++i)
        f.line.next([&f, disturb](const Received& request) { disturb(f, request); });
    const auto id = works().at(work).start(f.subject());
    QTRY_COMPARE(f.subject().endings(id), 1);
    QCOMPARE(f.subject().outcome(id).status, Status::Unknown);
    QVERIFY(f.subject().outcome(id).failure.code == FailureCode::Malformed ||
            f.subject().outcome(id).failure.code == FailureCode::NoAnswer);
    QVERIFY(f.subject().outcome(id).values.isEmpty());
    QCOMPARE(f.line.writes(), works().at(work).isWrite ? 1 : 0);

    const auto next = f.subject().read({ItemId::Span});
    QTRY_COMPARE(f.subject().endings(next), 1);
    QCOMPARE(f.subject().outcome(next).status, Status::Done);
    QCOMPARE(f.subject().outcome(next).values.value(ItemId::Span), 10'000);
    QCOMPARE(f.subject().endings(id), 1);
}

void RtuFaultsTest::disturbedCoilsAreNeverTaken_data()
{
    QTest::addColumn<int>("fault");
    for (int fault = 0; fault < faults().size(); ++fault)
        QTest::newRow(faults().at(fault).name) << fault;
}

/// Function 01: a doubtful unit stays so until its coils have come undisturbed.
void RtuFaultsTest::disturbedCoilsAreNeverTaken()
{
    QFETCH(int, fault);
    RtuLinkFixture f;
    f.openAll();
    f.line.next(lineSilence);
    const auto lost = f.subject().write({{ItemId::OutputDelayTimerSetting, 77}});
    QTRY_COMPARE(f.subject().endings(lost), 1);
    f.line.received.clear();
    const Disturb disturb = faults().at(fault).disturb;
    f.line.nextCoils([&f, disturb](const Received& request) { disturb(f, request); });
    const auto id = f.subject().write({{ItemId::OutputDelayTimerSetting, 78}});
    QTRY_COMPARE(f.subject().endings(id), 1);
    QCOMPARE(f.subject().outcome(id).status, Status::Unknown);
    QCOMPARE(f.line.writes(), 0); // It has not even gone out.
    const auto next = f.subject().read({ItemId::Span});
    QTRY_COMPARE(f.subject().endings(next), 1);
    QCOMPARE(f.subject().outcome(next).values.value(ItemId::Span), 10'000);
}

void RtuFaultsTest::lateAnswerIsNotTheAnswerToTheSameReadAgain_data()
{
    QTest::addColumn<int>("late");
    for (const int ms : {60, 75, 80, 85, 90, 95, 100, 110, 130, 170, 200})
        QTest::addRow("%d ms", ms) << ms;
}

/// The first read's answer comes about when it is given up, while the coils are asked for, or later, and the
/// value has changed since.
void RtuFaultsTest::lateAnswerIsNotTheAnswerToTheSameReadAgain()
{
    QFETCH(int, late);
    RtuLinkFixture f;
    f.openAll();
    f.line.registers[400101] = 1111;
    f.line.registers[400102] = 0;
    int asked = 0;
    f.line.next([&](const Received& request) {
        f.line.hold(late);
        f.line.send(f.line.goodFrame(request));
        f.line.registers[400101] = 2222;
        asked = int(f.line.received.size());
    });
    const auto id = f.subject().read({ItemId::HighSetValue});
    QTRY_COMPARE(f.subject().endings(id), 1);
    const bool inTime = f.line.received.size() == asked; // Nothing was asked again: it is the answer.
    if (f.subject().outcome(id).status == Status::Done)
        QCOMPARE(f.subject().outcome(id).values.value(ItemId::HighSetValue), inTime ? 1111 : 2222);
    for (int i = 0; i < 4; ++i) {
        const auto next = f.subject().read({ItemId::HighSetValue});
        QTRY_COMPARE(f.subject().endings(next), 1);
        if (f.subject().outcome(next).status == Status::Done)
            QCOMPARE(f.subject().outcome(next).values.value(ItemId::HighSetValue), 2222);
        else
            QVERIFY(i < 2); // Once the late answer is through, all is well.
        QCOMPARE(f.subject().endings(id), 1);
    }
}

/// The answer comes exactly while the unit is asked for its coils, in one piece with theirs and before them.
void RtuFaultsTest::lateAnswerInFrontOfTheCoilsIsLeftAside()
{
    RtuLinkFixture f;
    f.openAll();
    f.line.registers[400101] = 1111;
    f.line.registers[400102] = 0;
    QByteArray late;
    f.line.next([&](const Received& request) { late = f.line.goodFrame(request); });
    f.line.nextCoils([&](const Received& request) {
        f.line.registers[400101] = 2222;
        f.line.send(late);
        const QByteArray coils = f.line.goodFrame(request);
        QTimer::singleShot(5, &f.line, [&f, coils] { f.line.send(coils); });
    });
    const auto id = f.subject().read({ItemId::HighSetValue});
    QTRY_COMPARE(f.subject().endings(id), 1);
    QCOMPARE(f.subject().outcome(id).status, Status::Done);
    QCOMPARE(f.subject().outcome(id).values.value(ItemId::HighSetValue), 2222);
    QList<ports::Frame> malformed = f.log.with(ports::FrameMeaning::Malformed);
    QCOMPARE(malformed.size(), 1);
    QCOMPARE(malformed.first().arguments.first(), QStringLiteral("late"));
    QCOMPARE(malformed.first().bytes, late);
}

void RtuFaultsTest::twoAnswersInOneGoAreNotTakenForOne()
{
    RtuLinkFixture f;
    f.openAll();
    f.line.next([&f](const Received& request) {
        const QByteArray one = ScriptedLine::frame(request.unit, QByteArray::fromHex("030411110000"));
        f.line.send(one + f.line.goodFrame(request));
    });
    const auto id = f.subject().read({ItemId::Span});
    QTRY_COMPARE(f.subject().endings(id), 1);
    QCOMPARE(f.subject().outcome(id).status, Status::Done); // The repeated read.
    QCOMPARE(f.subject().outcome(id).values.value(ItemId::Span), 10'000);
}

void RtuFaultsTest::lateAnswerOfOneUnitDoesNotHurtAnother()
{
    RtuLinkFixture f({1, 2});
    f.openAll();
    QByteArray late;
    f.line.next([&](const Received& request) { late = f.line.goodFrame(request); });
    const auto lost = f.subjects.at(0)->write({{ItemId::OutputDelayTimerSetting, 5}});
    QTRY_COMPARE(f.subjects.at(0)->endings(lost), 1);
    f.line.next([&](const Received& request) {
        f.line.send(late);
        const QByteArray answer = f.line.goodFrame(request);
        QTimer::singleShot(5, &f.line, [&f, answer] { f.line.send(answer); });
    });
    const auto other = f.subjects.at(1)->read({ItemId::DeviceAddress});
    QTRY_COMPARE(f.subjects.at(1)->endings(other), 1);
    QCOMPARE(f.subjects.at(1)->outcome(other).status, Status::Done);
    QCOMPARE(f.subjects.at(1)->outcome(other).values.value(ItemId::DeviceAddress), 2000);
    const auto again = f.subjects.at(0)->read({ItemId::DeviceAddress});
    QTRY_COMPARE(f.subjects.at(0)->endings(again), 1);
    QCOMPARE(f.subjects.at(0)->outcome(again).values.value(ItemId::DeviceAddress), 1000);
}

void RtuFaultsTest::lateAnswerWithNobodyAskingMakesTheUnitDoubtful()
{
    RtuLinkFixture f;
    f.openAll();
    const auto first = f.subject().read({ItemId::Span});
    QTRY_COMPARE(f.subject().endings(first), 1);
    QVERIFY(!f.line.received.last().isCoils());
    f.line.received.clear();
    f.line.send(ScriptedLine::frame(1, QByteArray::fromHex("030411110000")));
    QTRY_COMPARE(f.log.with(ports::FrameMeaning::Malformed).size(), 1);
    const auto id = f.subject().read({ItemId::Span});
    QTRY_COMPARE(f.subject().endings(id), 1);
    QCOMPARE(f.subject().outcome(id).values.value(ItemId::Span), 10'000);
    QCOMPARE(f.line.received.size(), 2);
    QVERIFY(f.line.received.first().isCoils());
}

/// A second answer to the same request, as two units with one address give: it comes in the silence in front
/// of the next request, which looks just like the first.
void RtuFaultsTest::secondAnswerIsNotTheAnswerToTheNextRequest()
{
    RtuLinkFixture f;
    f.openAll(); // At 230,400 bps the silence lasts 2 ms.
    QSignalSpy finished(f.subject().link.get(), &ports::SensorLink::finished);
    int wrong = 0;
    int right = 0;
    for (int i = 0; i < 30; ++i) {
        f.line.next([&f, i](const Received& request) {
            f.line.send(f.line.goodFrame(request));
            const QByteArray second = ScriptedLine::frame(request.unit, QByteArray::fromHex("030411110000"));
            QTimer::singleShot(i % 2, Qt::PreciseTimer, &f.line, [&f, second] { f.line.send(second); });
        });
        const auto first = f.subject().read({ItemId::Span});
        const auto next = f.subject().read({ItemId::Span});
        while (f.subject().endings(next) == 0)
            QVERIFY(finished.wait(5000)); // An event loop that does not sleep: a millisecond counts.
        for (const auto id : {first, next}) {
            if (f.subject().outcome(id).status != Status::Done)
                continue;
            const auto span = f.subject().outcome(id).values.value(ItemId::Span);
            ++(span == 10'000 ? right : wrong);
        }
    }
    QVERIFY2(right > 30, qPrintable(QString::number(right)));
    QCOMPARE(wrong, 0);
}

void RtuFaultsTest::noiseBetweenFramesDoesNoHarm()
{
    RtuLinkFixture f;
    f.openAll();
    for (int i = 0; i < 10; ++i) {
        f.line.send(noiseBytes.first(1 + i % 4));
        const auto id = f.subject().read({ItemId::Span});
        QTRY_COMPARE(f.subject().endings(id), 1);
        QCOMPARE(f.subject().outcome(id).status, Status::Done);
        QCOMPARE(f.subject().outcome(id).values.value(ItemId::Span), 10'000);
    }
}

void RtuFaultsTest::pollsShowNoValueOfADisturbedAnswer()
{
    RtuLinkFixture f;
    f.openAll();
    f.line.registers[400020] = 0x1234;
    int asked = 0;
    f.line.always([&](const Received& request) {
        QByteArray bytes = f.line.goodFrame(request);
        ++asked;
        if (!request.isCoils() && asked % 3 == 0)
            bytes[int(asked % bytes.size())] = char(bytes.at(asked % bytes.size()) ^ (1 << asked % 8));
        f.line.send(bytes);
    });
    f.subject().link->poll(1);
    QTRY_VERIFY_WITH_TIMEOUT(f.subject().measurements.size() >= 10 && f.subject().statistics.lost >= 3,
                             20'000);
    f.subject().link->poll(0);
    const measurement::Measurement good = f.subject().measurements.first();
    for (const measurement::Measurement& sample : f.subject().measurements) {
        QCOMPARE(sample.value, good.value);
        QCOMPARE(sample.state, good.state);
        QCOMPARE(sample.intensity, good.intensity);
    }
}

void RtuFaultsTest::everyByteFlippedAndEveryByteLost_data()
{
    QTest::addColumn<bool>("lost");
    QTest::newRow("flipped") << false;
    QTest::newRow("lost") << true;
}

void RtuFaultsTest::everyByteFlippedAndEveryByteLost()
{
    QFETCH(bool, lost);
    RtuLinkFixture f;
    f.openAll();
    const qsizetype length = 9; // Of the answer to a read of two registers.
    for (qsizetype at = 0; at < length; ++at) {
        f.line.next([&](const Received& request) {
            QByteArray bytes = f.line.goodFrame(request);
            QCOMPARE(bytes.size(), length);
            if (lost)
                bytes.remove(at, 1);
            else
                bytes[at] = char(bytes.at(at) ^ 0x01);
            f.line.send(bytes);
        });
        const auto id = f.subject().read({ItemId::Span});
        QTRY_COMPARE(f.subject().endings(id), 1);
        QCOMPARE(f.subject().outcome(id).status, Status::Done);
        QCOMPARE(f.subject().outcome(id).values.value(ItemId::Span), 10'000);
    }
}

void RtuFaultsTest::vanishedPortEndsEverythingAtOnce_data()
{
    QTest::addColumn<int>("work");
    for (int work = 0; work < works().size(); ++work)
        QTest::newRow(works().at(work).name) << work;
}

void RtuFaultsTest::vanishedPortEndsEverythingAtOnce()
{
    QFETCH(int, work);
    RtuLinkFixture f({1, 2});
    f.openAll();
    f.subjects.at(1)->link->poll(5);
    f.line.always([&f](const Received& request) {
        if (request.unit == 1)
            f.line.unplug();
        else
            f.line.send(f.line.goodFrame(request));
    });
    QElapsedTimer elapsed;
    elapsed.start();
    const auto id = works().at(work).start(f.subject());
    const auto waiting = f.subject().read({ItemId::Span}, ports::Urgency::Background);
    QTRY_COMPARE(f.subject().outcomes.size(), 2);
    QVERIFY(elapsed.elapsed() < 1000);
    for (const auto ended : {id, waiting}) {
        QCOMPARE(f.subject().endings(ended), 1);
        QCOMPARE(f.subject().outcome(ended).failure.code, FailureCode::ConnectionLost);
    }
    for (const auto& subject : f.subjects) {
        QTRY_COMPARE(subject->state(), ports::LinkState::Failed);
        QCOMPARE(subject->failure(), ports::OpenFailure::PortGone);
    }
    // Until the adapter is back a try ends at once.
    f.subject().link->open();
    QTRY_COMPARE(f.subject().reports.size(), 5);
    QCOMPARE(f.subject().failure(), ports::OpenFailure::NoSuchPort);
}

QTEST_GUILESS_MAIN(RtuFaultsTest)
#include "tst_rtu_faults.moc"
