#include "link_fixture.h"

#include <random>

using namespace lds;
using namespace lds::tests;
using catalog::ItemId;
using ports::FailureCode;
using ports::LinkState;
using ports::Status;

namespace {

using Received = ScriptedServer::Received;

constexpr int wrongValue = 4321; ///< What no answer to the request under test holds.

QByteArray spanPdu(int span)
{
    return QByteArray::fromHex("03 04") + QByteArray(1, char(span >> 8)) + QByteArray(1, char(span & 0xff)) +
           QByteArray(2, '\0');
}

} // namespace

/// What comes in is hostile until it is proven: nothing but the one right answer yields a value, every
/// request ends, and afterwards either the next request works or the connection is given up.
class LinkAnswersTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void answerInPiecesIsRead();
    void twoAnswersInOnePieceAreRead();
    void lateAnswerIsNotTakenForTheNext();
    void answerThatCameBeforeItsRequestIsNotTaken();
    void unaskedAnswerIsThrownAway();
    void answerWithAnotherTransactionIsNotTaken();
    void badAnswerGivesNoValue_data();
    void badAnswerGivesNoValue();
    void badAnswerIsReadOnceMore();
    void endlessAnswerDropsTheConnection();
    void halfAnAnswerDropsTheConnection();
    void shortLengthDoesNotReadIntoTheNextMessage();
    void garbageDropsTheConnection();
    void randomAnswersNeverGiveAWrongValue();
};

void LinkAnswersTest::answerInPiecesIsRead()
{
    LinkFixture f;
    f.openLink();
    f.server.next([&f](const Received& request) { f.server.sendByteByByte(f.server.goodFrame(request)); });
    const auto id = f.read({ItemId::Span});
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).values.value(ItemId::Span), 10'000);
}

void LinkAnswersTest::twoAnswersInOnePieceAreRead()
{
    LinkFixture f;
    f.openLink();
    Received first;
    f.server.next([&](const Received& request) { first = request; });
    f.server.next([&](const Received& request) {
        f.server.send(f.server.frame(first.transaction, first.unit, spanPdu(wrongValue)) +
                      f.server.goodFrame(request));
    });
    const auto id = f.read({ItemId::Span});
    QTRY_VERIFY(f.serverHas(1));
    f.clock->advanceMs(500);
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).values.value(ItemId::Span), 10'000);
}

void LinkAnswersTest::lateAnswerIsNotTakenForTheNext()
{
    LinkFixture f;
    f.openLink();
    f.server.always(silence);
    const auto write = f.write({{ItemId::KeyLock, 1}});
    QTRY_VERIFY(f.serverHas(1));
    const Received late = f.server.received.last();
    f.clock->advanceMs(500);
    QTRY_COMPARE(f.endings(write), 1);

    const auto read = f.read({ItemId::Span});
    QTRY_VERIFY(f.serverHas(2));
    f.server.send(f.server.goodFrame(late));
    settle();
    QCOMPARE(f.endings(read), 0);
    f.server.send(f.server.goodFrame(f.server.received.last()));
    QTRY_COMPARE(f.endings(read), 1);
    QCOMPARE(f.outcome(read).values.value(ItemId::Span), 10'000);
    QCOMPARE(f.endings(write), 1);
    QCOMPARE(f.outcome(write).status, Status::Unknown);
}

void LinkAnswersTest::answerThatCameBeforeItsRequestIsNotTaken()
{
    LinkFixture f;
    f.openLink();
    f.server.next([&f](const Received& request) {
        const auto following = quint16(request.transaction + 1);
        f.server.send(f.server.goodFrame(request) +
                      f.server.frame(following, request.unit, spanPdu(wrongValue)));
    });
    const auto first = f.read({ItemId::Span});
    const auto second = f.read({ItemId::Span});
    QTRY_COMPARE(f.endings(second), 1);
    QCOMPARE(f.outcome(first).values.value(ItemId::Span), 10'000);
    QCOMPARE(f.outcome(second).values.value(ItemId::Span), 10'000);
    QCOMPARE(f.sinceOpening(), 2);
}

void LinkAnswersTest::unaskedAnswerIsThrownAway()
{
    LinkFixture f;
    f.openLink();
    f.server.send(f.server.frame(9, 1, spanPdu(wrongValue)));
    settle();
    QVERIFY(f.outcomes.isEmpty());
    const auto id = f.read({ItemId::Span});
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).values.value(ItemId::Span), 10'000);
}

void LinkAnswersTest::answerWithAnotherTransactionIsNotTaken()
{
    LinkFixture f;
    f.openLink();
    f.server.always([&f](const Received& request) {
        f.server.send(f.server.frame(quint16(request.transaction + 100), request.unit, spanPdu(wrongValue)));
    });
    const auto id = f.read({ItemId::Span});
    QTRY_VERIFY(f.serverHas(1));
    settle();
    f.clock->advanceMs(500);
    QTRY_VERIFY(f.serverHas(2));
    settle();
    QCOMPARE(f.endings(id), 0);
    f.clock->advanceMs(500);
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).status, Status::Unknown);
    QCOMPARE(f.outcome(id).failure.code, FailureCode::NoAnswer);
    QVERIFY(f.outcome(id).values.isEmpty());
}

void LinkAnswersTest::badAnswerGivesNoValue_data()
{
    QTest::addColumn<QByteArray>("pdu");
    QTest::addColumn<int>("protocol");
    QTest::addColumn<int>("length");
    QTest::addColumn<int>("unit");
    QTest::addColumn<bool>("keepsConnection");
    const QByteArray good = spanPdu(wrongValue);
    QTest::newRow("function") << QByteArray::fromHex("04 04 10e1 0000") << 0 << -1 << 1 << true;
    QTest::newRow("function of another exception") << QByteArray::fromHex("86 02") << 0 << -1 << 1 << true;
    QTest::newRow("exception cut short") << QByteArray::fromHex("83") << 0 << -1 << 1 << true;
    QTest::newRow("exception too long") << QByteArray::fromHex("83 02 00") << 0 << -1 << 1 << true;
    QTest::newRow("function only") << QByteArray::fromHex("03") << 0 << -1 << 1 << true;
    QTest::newRow("cut short") << QByteArray::fromHex("03 04 10e1 00") << 0 << -1 << 1 << true;
    QTest::newRow("too long") << QByteArray::fromHex("03 04 10e1 0000 00") << 0 << -1 << 1 << true;
    QTest::newRow("byte count too small") << QByteArray::fromHex("03 02 10e1 0000") << 0 << -1 << 1 << true;
    QTest::newRow("byte count too large") << QByteArray::fromHex("03 06 10e1 0000") << 0 << -1 << 1 << true;
    QTest::newRow("byte count 0") << QByteArray::fromHex("03 00") << 0 << -1 << 1 << true;
    QTest::newRow("one register of two") << QByteArray::fromHex("03 02 10e1") << 0 << -1 << 1 << true;
    QTest::newRow("odd byte count") << QByteArray::fromHex("03 05 10e1 0000 00") << 0 << -1 << 1 << true;
    QTest::newRow("unit") << good << 0 << -1 << 2 << true;
    QTest::newRow("protocol") << good << 1 << -1 << 1 << false;
    QTest::newRow("length 0") << good << 0 << 0 << 1 << false;
    QTest::newRow("length 1") << good << 0 << 1 << 1 << false;
    QTest::newRow("length too small") << good << 0 << 3 << 1 << false;
    QTest::newRow("length too large") << good << 0 << 9 << 1 << false;
    QTest::newRow("length beyond any message") << good << 0 << 0xffff << 1 << false;
}

void LinkAnswersTest::badAnswerGivesNoValue()
{
    QFETCH(QByteArray, pdu);
    QFETCH(int, protocol);
    QFETCH(int, length);
    QFETCH(int, unit);
    QFETCH(bool, keepsConnection);
    LinkFixture f;
    f.openLink();
    f.server.always([&](const Received& request) {
        f.server.send(f.server.frame(request.transaction, quint8(unit), pdu, protocol, length));
    });
    const auto id = f.read({ItemId::Span});
    QTRY_VERIFY(f.serverHas(1));
    settle();
    f.clock->advanceMs(500);
    settle();
    f.clock->advanceMs(500);
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).status, Status::Unknown);
    QCOMPARE(f.outcome(id).failure.code, FailureCode::Malformed);
    QVERIFY(f.outcome(id).values.isEmpty());

    f.server.answerWell();
    settle();
    QCOMPARE(f.state(), keepsConnection ? LinkState::Open : LinkState::Failed);
    if (!keepsConnection) {
        QCOMPARE(f.failure(), ports::OpenFailure::Lost);
        f.openLink();
    }
    const auto next = f.read({ItemId::Span});
    QTRY_COMPARE(f.endings(next), 1);
    QCOMPARE(f.outcome(next).values.value(ItemId::Span), 10'000);
    QCOMPARE(f.endings(id), 1);
}

void LinkAnswersTest::badAnswerIsReadOnceMore()
{
    LinkFixture f;
    f.openLink();
    f.server.next(
        [&f](const Received& request) { f.server.answer(request, QByteArray::fromHex("03 02 10e1")); });
    const auto id = f.read({ItemId::Span});
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).status, Status::Done);
    QCOMPARE(f.outcome(id).values.value(ItemId::Span), 10'000);
    QCOMPARE(f.sinceOpening(), 2);
}

void LinkAnswersTest::endlessAnswerDropsTheConnection()
{
    LinkFixture f;
    f.openLink();
    f.server.next([&f](const Received&) { f.server.send(QByteArray(1'000'000, '\x01')); });
    const auto id = f.read({ItemId::Span});
    QTRY_COMPARE(f.state(), LinkState::Failed);
    QCOMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).failure.code, FailureCode::Malformed);
}

void LinkAnswersTest::halfAnAnswerDropsTheConnection()
{
    for (int size = 1; size < 13; ++size) {
        LinkFixture f;
        f.openLink();
        f.server.next(
            [&](const Received& request) { f.server.send(f.server.goodFrame(request).first(size)); });
        const auto id = f.read({ItemId::Span});
        const auto waiting = f.write({{ItemId::KeyLock, 1}});
        QTRY_VERIFY(f.serverHas(1));
        settle();
        QCOMPARE(f.endings(id), 0);
        f.clock->advanceMs(500);
        QTRY_COMPARE(f.state(), LinkState::Failed);
        QCOMPARE(f.failure(), ports::OpenFailure::Lost);
        QCOMPARE(f.endings(id), 1);
        QCOMPARE(f.outcome(id).failure.code, FailureCode::Malformed);
        QCOMPARE(f.endings(waiting), 1);
        QCOMPARE(f.outcome(waiting).failure.code, FailureCode::ConnectionLost);
        QCOMPARE(f.server.writes(), 0);
    }
}

/// QModbus reads a PDU as long as its byte count says, over the end of the message. The registers would
/// then be the bytes of whatever comes behind it.
void LinkAnswersTest::shortLengthDoesNotReadIntoTheNextMessage()
{
    LinkFixture f;
    f.openLink();
    f.server.always([&f](const Received& request) {
        const QByteArray header =
            f.server.frame(request.transaction, request.unit, QByteArray::fromHex("03 04"));
        f.server.send(header + QByteArray::fromHex("03e8 0000 0003 01 83 02"));
    });
    const auto id = f.read({ItemId::Span});
    QTRY_VERIFY(f.serverHas(1));
    settle();
    f.clock->advanceMs(500);
    settle();
    f.clock->advanceMs(500);
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.outcome(id).status, Status::Unknown);
    QVERIFY(f.outcome(id).values.isEmpty());
}

void LinkAnswersTest::garbageDropsTheConnection()
{
    LinkFixture f;
    f.openLink();
    f.server.send("SSH-2.0-OpenSSH_9.2p1\r\n");
    QTRY_COMPARE(f.state(), LinkState::Failed);
    QCOMPARE(f.failure(), ports::OpenFailure::Lost);
}

void LinkAnswersTest::randomAnswersNeverGiveAWrongValue()
{
    std::mt19937 random(20'240'501);
    const auto below = [&random](int limit) { return int(random() % unsigned(limit)); };
    LinkFixture f;
    f.openLink();
    int done = 0;
    for (int round = 0; round < 2000; ++round) {
        if (f.state() != LinkState::Open) {
            f.server.answerWell();
            f.openLink();
        }
        f.server.always([&](const Received& request) {
            QByteArray bytes = f.server.goodFrame(request);
            // Everything but the value itself may change; the value's bytes may be missing or have company.
            for (int change = below(3); change > 0; --change)
                bytes[below(9)] = char(below(256));
            switch (below(5)) {
            case 0:
                bytes = bytes.first(below(int(bytes.size()) + 1));
                break;
            case 1:
                bytes += QByteArray(below(20), char(below(256)));
                break;
            default:
                break;
            }
            f.server.send(bytes);
        });
        const auto id = f.read({ItemId::Span});
        for (int i = 0; i < 200 && f.endings(id) == 0; ++i) {
            settle();
            if (f.endings(id) == 0)
                f.clock->advanceMs(250);
        }
        QCOMPARE(f.endings(id), 1);
        const ports::Outcome outcome = f.outcome(id);
        if (outcome.status == Status::Done) {
            ++done;
            QCOMPARE(outcome.values.value(ItemId::Span), 10'000);
        } else {
            QVERIFY(outcome.values.isEmpty());
        }
        f.outcomes.clear();
    }
    QVERIFY(done > 100 && done < 2000);
}

QTEST_GUILESS_MAIN(LinkAnswersTest)
#include "tst_link_answers.moc"
