#include "fake_link.h"
#include "item_text.h"
#include "manual_scheduler.h"
#include "sentences.h"

#include <QSet>
#include <QTest>

using namespace lds;
using namespace lds::ui;
using namespace Qt::StringLiterals;
using catalog::ItemId;
using catalog::SensorModel;
using settings::Rule;

/// A set of sentences of which each must say something of its own.
class Distinct {
public:
    void add(const QString& sentence, const char* file, int line)
    {
        if (sentence.isEmpty() || sentence.contains(u'%') || m_seen.contains(sentence))
            QTest::qFail(qPrintable(u"empty, unfinished or said twice: "_s + sentence), file, line);
        m_seen.insert(sentence);
    }
    qsizetype count() const { return m_seen.size(); }

private:
    QSet<QString> m_seen;
};
#define ADD(distinct, sentence) (distinct).add(sentence, __FILE__, __LINE__)

class SentencesTest : public QObject {
    Q_OBJECT

    static settings::Values state()
    {
        settings::Values values;
        for (const auto& item : catalog::Catalog::hlG2().items())
            values.insert(item.id, item.limitsFor(SensorModel::HlG203).defaultValue);
        values.insert(ItemId::HighSetValue, 10'100);
        values.insert(ItemId::LowSetValue, 10'000);
        values.insert(ItemId::Hysteresis, 100);
        return values;
    }

    static QString refusal(Rule rule, QList<ItemId> items)
    {
        return refusalSentence({rule, std::move(items)}, SensorModel::HlG203, state());
    }

private Q_SLOTS:
    void everyParseErrorNamesTheItemAndWhatWasTyped()
    {
        using settings::ParseError;
        const auto& high = catalog::hlG2(ItemId::HighSetValue);
        Distinct seen;
        for (const auto error : {ParseError::Empty, ParseError::NotANumber, ParseError::TooManyDecimals,
                                 ParseError::OutOfRange, ParseError::NotAChoice}) {
            const QString sentence = parseFailureSentence(high, SensorModel::HlG203, {error, {}}, u"abc"_s);
            ADD(seen, sentence);
            QVERIFY2(sentence.startsWith(itemName(high)), qPrintable(sentence));
            QVERIFY2(error == ParseError::Empty || sentence.contains(u"“abc”"_s), qPrintable(sentence));
        }
        QVERIFY(parseFailureSentence(high, SensorModel::HlG203, {ParseError::OutOfRange, {}}, u"99"_s)
                    .contains(u"from \u22129.5000 to +9.5000"_s));
    }

    void everyRuleHasASentenceOfItsOwn()
    {
        Distinct seen;
        for (const Rule rule :
             {Rule::NotWritable, Rule::OutOfRange, Rule::NotAChoice, Rule::HighNotAboveLow,
              Rule::WindowNotOverHysteresis, Rule::ToleranceNotOverHysteresis, Rule::OneShotNeedsNormalHold,
              Rule::PortReserved, Rule::PortsEqual, Rule::AddressFirstOctet, Rule::MaskNotContiguous,
              Rule::AddressHostBits, Rule::AddressNetworkBits, Rule::GatewayFirstOctet, Rule::GatewayHostBits,
              Rule::GatewayOtherNetwork, Rule::GroupIncomplete})
            ADD(seen, refusal(rule, {ItemId::HoldMode, ItemId::LowSetValue}));
        QCOMPARE(seen.count(), 17);
    }

    void aRulesSentenceNamesTheNumbers()
    {
        const QString window = refusal(Rule::WindowNotOverHysteresis, {ItemId::HighSetValue});
        QVERIFY2(window.contains(u"0.0100"_s) && window.contains(u"0.0200"_s), qPrintable(window));
        const QString order = refusal(Rule::HighNotAboveLow, {ItemId::HighSetValue});
        QVERIFY2(order.contains(u"+1.0100"_s) && order.contains(u"+1.0000"_s), qPrintable(order));
        QVERIFY(refusal(Rule::GatewayOtherNetwork, {}).contains(u"192.168.1.6"_s));
    }

    void aRuleWithoutItsNumbersStillReadsAsASentence()
    {
        const QString sentence =
            refusalSentence({Rule::WindowNotOverHysteresis, {}}, SensorModel::HlG203, settings::Values{});
        QVERIFY2(sentence.contains(u"twice the hysteresis"_s) && !sentence.contains(u'?'),
                 qPrintable(sentence));
    }

    void everyFailureOfARequestHasASentenceThatNamesTheItem()
    {
        using ports::FailureCode;
        const auto& span = catalog::hlG2(ItemId::Span);
        Distinct seen;
        for (const auto code :
             {FailureCode::FunctionNotSupported, FailureCode::AddressRefused, FailureCode::ValueRefused,
              FailureCode::NotReady, FailureCode::OtherRefusal, FailureCode::NoAnswer, FailureCode::Malformed,
              FailureCode::ConnectionLost, FailureCode::NotConnected, FailureCode::NotReachable,
              FailureCode::ViewOnly}) {
            const QString sentence = failureSentence({code, 0x0a, {}}, &span);
            ADD(seen, sentence);
            QVERIFY2(sentence.startsWith(itemName(span)), qPrintable(sentence));
            QVERIFY(!failureSentence({code, 0x0a, {}}, nullptr).isEmpty());
        }
        QVERIFY(failureSentence({FailureCode::OtherRefusal, 0x0a, {}}, &span).contains(u"0A"_s));
        QVERIFY(failureSentence({FailureCode::None, 0, {}}, &span).isEmpty());
    }

    void everyFailureToConnectSaysWhereAndWhatToCheck()
    {
        using ports::OpenFailure;
        ports::ConnectionUrl url;
        url.host = u"sensor7"_s;
        url.port = 1502;
        Distinct seen;
        for (const auto failure :
             {OpenFailure::HostNotFound, OpenFailure::Refused, OpenFailure::NoAnswer, OpenFailure::NotASensor,
              OpenFailure::NotReady, OpenFailure::Lost, OpenFailure::NoSuchPort, OpenFailure::PortBusy,
              OpenFailure::PortNotPermitted, OpenFailure::PortUnusable, OpenFailure::PortSettingsDiffer,
              OpenFailure::PortGone}) {
            const QString sentence =
                openFailureSentence({ports::LinkState::Failed, failure, u"detail"_s, true}, url);
            ADD(seen, sentence);
            QVERIFY2(sentence.contains(u"sensor7"_s), qPrintable(sentence));
        }
    }

    void statesHaveWordsOfTheirOwn()
    {
        using sensor::Connection;
        using sensor::Saved;
        Distinct connections;
        for (const auto connection : {Connection::Closed, Connection::Opening, Connection::Reading,
                                      Connection::Ready, Connection::Reconnecting})
            ADD(connections, connectionWord(connection));
        Distinct saved;
        for (const auto each : {Saved::Unknown, Saved::Saved, Saved::NotSaved})
            ADD(saved, savedWord(each));
    }

    void everyMessageReadsAsASentence()
    {
        using ports::FrameMeaning;
        Distinct seen;
        const auto say = [](FrameMeaning meaning, const QStringList& arguments) {
            ports::Frame frame;
            frame.meaning = meaning;
            frame.arguments = arguments;
            return frameSentence(frame);
        };
        ADD(seen, say(FrameMeaning::Connecting, {u"127.0.0.1"_s, u"502"_s}));
        ADD(seen, say(FrameMeaning::Connected, {}));
        ADD(seen, say(FrameMeaning::Disconnected, {u"closed by the other side"_s}));
        ADD(seen, say(FrameMeaning::Read, {u"400101"_s, u"400171"_s}));
        ADD(seen, say(FrameMeaning::ReadCoils, {u"1"_s, u"16"_s}));
        ADD(seen, say(FrameMeaning::Write, {u"400101"_s, u"400102"_s, u"17500"_s}));
        ADD(seen, say(FrameMeaning::Answer, {u"400020"_s, u"400021"_s, u"12345"_s}));
        ADD(seen, say(FrameMeaning::AnswerCoils, {u"1"_s, u"16"_s}));
        ADD(seen, say(FrameMeaning::Written, {u"400101"_s, u"400102"_s}));
        ADD(seen, say(FrameMeaning::NoAnswer, {u"500"_s}));
        for (const QString& what : {u"short"_s, u"length"_s, u"function"_s, u"echo"_s, u"empty"_s,
                                    u"transaction"_s, u"unit"_s, u"header"_s}) {
            ADD(seen, say(FrameMeaning::Malformed, {what}));
            QVERIFY2(!say(FrameMeaning::Malformed, {what}).endsWith(u": "_s + what),
                     qPrintable(what)); // a bare code
        }
        ADD(seen, say(FrameMeaning::Unknown, {}));
        for (const QString& code : {u"1"_s, u"2"_s, u"3"_s, u"4"_s, u"9"_s})
            ADD(seen, say(FrameMeaning::Refused, {u"16"_s, code}));
        QCOMPARE(say(FrameMeaning::Read, {u"400101"_s, u"400171"_s}), u"read 400101–400171"_s);
        QVERIFY(say(FrameMeaning::Refused, {u"16"_s, u"3"_s}).startsWith(u"refused: value out of range"_s));
        QVERIFY(
            say(FrameMeaning::Refused, {u"0x10"_s, u"0x03"_s}).startsWith(u"refused: value out of range"_s));
    }

    void aMessageWithoutItsArgumentsDoesNotBreak()
    {
        for (int meaning = 0; meaning <= int(ports::FrameMeaning::Unknown); ++meaning) {
            ports::Frame frame;
            frame.meaning = ports::FrameMeaning(meaning);
            QVERIFY(!frameSentence(frame).isEmpty());
        }
    }

    void anItemThatCannotBeChangedSaysWhy()
    {
        ports::ManualScheduler scheduler;
        support::FakeLinkFactory links(scheduler);
        ports::ConnectionUrl url;
        url.host = u"sensor"_s;
        const auto reason = [&](ItemId id, const sensor::SensorSession& session) {
            return unreachableReason(catalog::hlG2(id), session);
        };
        sensor::SensorSession session(url, links, scheduler);
        QVERIFY(reason(ItemId::HighSetValue, session).isEmpty()); // not connected is not the item's trouble
        links.sensor(url).hide(ItemId::EcoMode);
        session.open();
        support::settle();
        Distinct seen;
        ADD(seen, reason(ItemId::MeasuredValue, session));
        ADD(seen, reason(ItemId::PortSlmp, session));
        ADD(seen, reason(ItemId::MacAddress, session));
        ADD(seen, reason(ItemId::BrightnessTuning, session));
        ADD(seen, reason(ItemId::EcoMode, session));
        QVERIFY(reason(ItemId::PortSlmp, session).contains(u"76"_s));
        QVERIFY(reason(ItemId::HighSetValue, session).isEmpty());
        QVERIFY(reason(ItemId::SetValueSaving, session).isEmpty());

        url.viewOnly = true;
        url.port = 503;
        sensor::SensorSession viewing(url, links, scheduler);
        viewing.open();
        support::settle();
        ADD(seen, reason(ItemId::HighSetValue, viewing));
    }
};

QTEST_GUILESS_MAIN(SentencesTest)
#include "tst_sentences.moc"
